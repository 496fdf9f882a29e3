// Draft: the pull that the soil puts on an implement's tools.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "terrains/soil.h"
#include "vehicle_models/implement.h"

namespace headland {

// A row of ASABE D497.7, table of draft parameters. Coefficients per metre of width or per tool,
// and per centimetre of depth.
struct D497Tool {
  std::string_view name;  // as in a drive.yaml
  bool per_tool = false;
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  std::array<double, kSoilTextures> texture_factor{1.0, 1.0, 1.0};
  bool at_any_depth = false;  // T is 1, whatever the depth
};
std::span<const D497Tool> d497_tools();

// Draft [N] >= 0 of the lowered implement at a speed (either sign) on soil of this texture. By the
// soil: D = Fi (A + B S + C S^2) W T (ASABE D497.7), S in km/h, W the working width in m or the
// number of tools, T the depth in cm. Without a tillage law, draft_n_per_m times the width.
// Typical of its class of soil: D497 gives +-25 to 50 % about it.
double draft_n(const Implement& implement, SoilTexture texture, double speed_mps);

}  // namespace headland
