// Where the perspective pictures are taken from.
#pragma once

#include <optional>

#include "render/camera.h"
#include "render/page.h"
#include "render/pictures.h"
#include "render/relief.h"

namespace headland {

// A block of the terrain seen from above one of its sides.
struct FieldView {
  Camera camera;
  Relief relief;
  Extent block;
  double bottom_D = 0.0;
  double heading_rad = 0.0;  // the camera looks along
};

// The whole field, as near as the page's main box allows, from the side where it is seen largest
// (the one facing a slope, the long one). Gentle relief is stretched by a whole number unless the
// exaggeration is given.
FieldView field_view(const PictureScene& scene, const Page& page,
                     std::optional<double> exaggeration = std::nullopt);

// The page of draw_view, whose column holds the close-up.
Page view_page(const PictureSize& size);

// The last sample with a finite place; null when there is none. A run that diverged may end
// beyond any picture.
const RunSample* last_pose(const RunRecord& run);

// The vehicle at that sample from ahead and beside, relief as it is.
FieldView close_up(const PictureScene& scene, const RunSample& sample, const Box& view_px);

// From behind and above, `heading_rad` being where it has been heading of late.
// Heights count from `relief`'s base, or from the vehicle.
FieldView chase_view(const PictureScene& scene, const RunSample& sample, double heading_rad,
                     const Box& view_px, std::optional<Relief> relief = std::nullopt);

// Mean direction of the vehicle over the last seconds before that time, which a camera behind it
// can follow without swinging.
double trailing_heading_rad(const RunRecord& run, double time_s);

}  // namespace headland
