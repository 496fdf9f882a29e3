// The ground of a field as bare images, for maps that are put together elsewhere.
#pragma once

#include "evaluate/coverage.h"
#include "render/image.h"
#include "render/pictures.h"
#include "render/relief.h"

namespace headland {

// North up, all of `extent` of W, no margin.
struct GroundImage {
  Extent extent;
  Image image;
};

// Shaded relief with contours around the field, without coverage.
GroundImage draw_relief(const PictureScene& scene, int longest_side_px);

// Times covered in the colours of the field's map, clear where nothing is to be said. One pixel a
// cell of the raster, or of several cells where it is larger than `longest_side_px`.
GroundImage coverage_image(const CoverageRaster& coverage, int longest_side_px);

}  // namespace headland
