// A vehicle on one page: from ahead, from its side and from behind, with its figures.
#pragma once

#include <span>
#include <string>

#include "render/image.h"
#include "render/pictures.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// A line of the page's column.
struct SheetFigure {
  std::string label;
  std::string value;
};

// On level ground, implement down, wheels straight. The side view marks the centre of mass and the
// ground points about which it would tip forwards and backwards, the rear view those to the sides.
// A mesh that cannot be read is replaced by a plain box, and the page says so. Throws InputError
// as the pictures of a run do (render/pictures.h).
Image draw_vehicle_sheet(const Vehicle& vehicle, std::span<const SheetFigure> figures,
                         const PictureSize& size);

}  // namespace headland
