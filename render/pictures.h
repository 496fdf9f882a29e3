// The pictures of a run, drawn off-screen.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "evaluate/coverage.h"
#include "evaluate/verdict.h"
#include "planner/path.h"
#include "render/image.h"
#include "render/path_quantity.h"
#include "sim/run_record.h"
#include "terrains/field.h"
#include "terrains/heightfield.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// What is drawn. Nothing is owned. The pictures come from the record alone, never from the
// physics: a record read back from disk gives the same picture. A run without samples, a path
// without segments and a coverage raster without cells leave out what they would have shown.
struct PictureScene {
  const Field& field;
  const Heightfield& terrain;
  const Vehicle& vehicle;
  const Path& path;
  const RunRecord& run;
  const CoverageRaster& coverage;
  const Verdict* verdict = nullptr;  // null: not judged, the pictures then say nothing of it
  std::string path_file{};           // name of what was driven, for the subtitle; empty: a plan
  // The moment shown: `run` and `coverage` then reach only that far (render/run_moment.h). None:
  // all.
  std::optional<double> moment_s{};
  // What a damaged record lacks, for the title. Ground that is not worked there may have been.
  std::string missing{};
  // False: level ground stands in for the terrain, which pictures then say nothing of.
  bool terrain_known = true;
};

// Pixels, at least 240 x 240; the largest size depends on OpenGL and memory (8192 x 8192 works).
struct PictureSize {
  int width = 1600;
  int height = 1000;
};

// All throw InputError for a size that cannot be drawn and for missing fonts (names the
// package). Same scene and size, same bytes.

// From above: relief, boundary, holes, obstacles, driven coverage by times covered, planned and
// driven path, start and end, where the verdict's reasons lie, coordinates of W along the frame,
// scale bar, north arrow, legend.
Image draw_field_map(const PictureScene& scene, const PictureSize& size);

// Perspective of the whole field: lit terrain with the driven swaths on it, obstacles, and the
// vehicle where it ended, once in its place and once from close by. A mesh that cannot be read is
// replaced by a plain box, and the picture says so.
// With a quantity the driven way is coloured by it. An exaggeration is that of the relief; none: as
// the relief asks for.
struct ViewOptions {
  std::optional<PathQuantity> overlay{};
  std::optional<double> exaggeration{};
};
Image draw_view(const PictureScene& scene, const PictureSize& size,
                const ViewOptions& options = {});

// From above: the driven path coloured by battery energy per metre over the relief, with a scale.
Image draw_energy_map(const PictureScene& scene, const PictureSize& size);

// The ground's height along the driven way, or failing that the path, from the side: movements, the
// machine's place, heights stretched (by `exaggeration`; none: to fill the picture), the line
// coloured by `overlay`.
Image draw_elevation(const PictureScene& scene, const PictureSize& size,
                     const ViewOptions& options = {});

// The same as the energy map for any quantity.
Image draw_quantity_map(const PictureScene& scene, const PictureSize& size, PathQuantity quantity);

}  // namespace headland
