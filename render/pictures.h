// The three pictures of an evaluated run, drawn off-screen.
#pragma once

#include <filesystem>

#include "evaluate/coverage.h"
#include "planner/path.h"
#include "render/image.h"
#include "sim/run_record.h"
#include "terrains/field.h"
#include "terrains/heightfield.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// What is drawn. Nothing is owned. The pictures come from the record alone, never from the
// physics: a record read back from disk gives the same picture.
struct PictureScene {
  const Field& field;
  const Heightfield& terrain;
  const Vehicle& vehicle;
  const Path& path;
  const RunRecord& run;
  const CoverageRaster& coverage;
};

struct PictureSize {
  int width = 1600;
  int height = 1000;
};

// From above: relief, boundary, holes, obstacles, driven coverage by times covered, planned and
// driven path, start and end, scale bar, north arrow, legend.
Image draw_field_map(const PictureScene& scene, const PictureSize& size);

// Perspective of the whole field: lit terrain with the driven swaths on it, obstacles, and the
// vehicle's mesh where it ended.
Image draw_view(const PictureScene& scene, const PictureSize& size);

// From above: the driven path coloured by battery energy per metre over the relief, with a scale.
Image draw_energy_map(const PictureScene& scene, const PictureSize& size);

// Writes a PNG to a temporary name and renames it. Throws InputError when it cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

}  // namespace headland
