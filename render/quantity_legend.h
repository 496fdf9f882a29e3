// The colours of a quantity along the way, on maps and in perspective.
#pragma once

#include <functional>
#include <optional>

#include "render/page.h"
#include "render/path_quantity.h"

namespace headland {

// What colours the way of a run; without values nothing was driven.
struct WayColours {
  PathQuantity quantity = PathQuantity::kEnergyPerMetre;
  std::vector<double> values;  // one a sample
  QuantityScale scale;
};
WayColours way_colours(const RunRecord& run, PathQuantity quantity);

// The way through `place`, which gives the pixel of a sample, null where it is not seen; coloured
// piece by piece.
void draw_way(Sheet& sheet, const RunRecord& run, const WayColours& colours, double width_px,
              const std::function<std::optional<Eigen::Vector3d>(const RunSample&)>& place);

// Heading, scale with round ticks and `scale_units` tall, smallest, median and largest value.
void legend_way(Legend& legend, const WayColours& colours, double scale_units = 210.0);

// The scale alone, lying, with its title and the values at its ends, within the box.
void draw_lying_scale(Sheet& sheet, Typeface& typeface, const Page& page, const WayColours& colours,
                      const Box& box_px);

}  // namespace headland
