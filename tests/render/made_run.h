// A run made by hand for the pictures: no planner, no physics.
#pragma once

#include "render/pictures.h"

namespace headland {

struct MadeRun {
  Field field;
  Heightfield terrain;
  Vehicle vehicle;
  Path path;
  RunRecord run;
  CoverageRaster coverage;
  PictureScene scene() const { return {field, terrain, vehicle, path, run, coverage}; }
};

// Rectangle of the given size with its lower left corner at W's origin, level ground at height 100,
// terrain reaching margin_m beyond, no path, nothing driven, an empty raster of 0.25 m cells.
MadeRun level_run(double width_m, double height_m, double margin_m);

// Rolling ground, an irregular boundary with a hole and obstacles, swaths up and down with turns,
// one swath left out and one driven twice, power that follows the slope.
MadeRun rolling_run(double size_m, double working_width_m);

// Marks the cells under a strip of the given width along a line as covered once more.
void cover_strip(CoverageRaster& coverage, const Eigen::Vector2d& from_W,
                 const Eigen::Vector2d& to_W, double width_m);

}  // namespace headland
