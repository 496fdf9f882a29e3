// One moment of a run from close by: the machine in the field, what it does, where that is.
#pragma once

#include <string>
#include <vector>

#include "render/pictures.h"
#include "render/quantity_legend.h"
#include "render/world.h"

namespace headland {

enum class MomentCamera { kChase, kCloseUp };

struct MomentOptions {
  MomentCamera camera = MomentCamera::kChase;
  std::string title{};                    // in the caption; empty: the field's name
  std::string value{};                    // after it
  std::optional<PathQuantity> overlay{};  // colours the way driven so far
};

// The scene ends at the moment (PictureScene::moment_s). Under it a caption with time, speed, power
// and charge and what the colours mean, in the corner a map. Throws InputError as the other
// pictures do, and for a run without samples.
Image draw_moment(const PictureScene& scene, const PictureSize& size, const MomentOptions& options);

// The planned way [m, W] from the sample's place on, as far as lines are drawn around the machine;
// `scene.run` tells how far it drove on its segment.
std::vector<Eigen::Vector2d> planned_ahead(const PictureScene& scene, const RunSample& sample);

// Lines on the ground around the machine: boundary, planned path ahead with arrows, and the way
// behind it, coloured if `colours` is given.
Sheet moment_lines(const PictureScene& scene, const FieldView& view, const RunSample& sample,
                   const WayColours* colours, double unit_px);

// The sun of moments stands still while cameras turn: in the south-west, half up.
Eigen::Vector3f moment_sun();

}  // namespace headland
