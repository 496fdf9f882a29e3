// A run's scene as glTF, for viewers that replay it.
#pragma once

#include <string>

#include "render/pictures.h"

namespace headland {

// The bytes of a binary glTF 2.0 file (GLB), y up as glTF has it. The root node's frame is D
// (render/relief.h) without exaggeration: x east, y north, z up from the lowest ground drawn, whose
// height is `base_m`. Nodes below it:
//   terrain             the ground around the field, evenly spaced nodes, positions alone
//   block               upright sides of that ground
//   passes, turns       planned lines
//   boundary            of the field and its holes
//   obstacles           a node each, its origin at the foot
//   vehicle             frame B, at the start of the run
//     body, wheel_0..3  as in RunSample: rear left, rear right, front left, front right
//     implement         its origin is the hitch pin of a trailed one, else B's
//       down, up
// Colours are those of vertices and materials. What the scene has not is left out.
struct SceneFile {
  std::string glb;
  double base_m = 0.0;
};
SceneFile scene_file(const PictureScene& scene);

inline constexpr int kSceneNodes = 200;  // of the terrain along its longer side

}  // namespace headland
