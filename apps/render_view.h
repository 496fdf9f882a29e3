// One picture of a run, as `headland render --view` asks for it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/stages.h"
#include "evaluate/report_record.h"
#include "render/path_quantity.h"

namespace headland {

struct ViewRequest {
  std::string view = "map";  // map, perspective, chase, elevation, grid, event:NAME
  PictureSize size;
  std::optional<double> at_s;  // none: the end of the run, or the event
  std::optional<double> exaggeration;
  std::optional<PathQuantity> overlay;
};

// Throws InputError for a view or event that is none, for what it does not take (an overlay of the
// grid), and for a moment outside the run or an event that did not happen. What the record lacks is
// not drawn.
Image draw_requested(const Job& job, const RecordedRun& recorded, const ViewRequest& request);

// Of planners on grid maps, drawn of the plan alone: the record is not looked at.
inline constexpr std::string_view kGridView = "grid";

// The names of the views, for messages and help.
std::vector<std::string> view_names();

// The run up to a moment, with its coverage, as a scene for the pictures.
struct MomentScene {
  MomentScene(const Job& job, const RecordedRun& recorded, std::optional<double> moment_s);
  RunRecord run;
  CoverageRaster coverage;
  PictureScene scene;
};

}  // namespace headland
