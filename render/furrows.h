// The ground that the implement worked, furrow beside furrow.
#pragma once

#include <vector>

#include "render/gl_objects.h"
#include "render/pictures.h"
#include "render/relief.h"

namespace headland {

struct FurrowLook {
  double now_s = 0.0;  // what was worked later is not there
  // Furrows fade out between these distances from the centre; 0: nowhere.
  Eigen::Vector2d centre_W = Eigen::Vector2d::Zero();
  double fade_from_m = 0.0;
  double fade_to_m = 0.0;
};

// Strips between the footprints of a run, draped on the ground, on the graphics side.
class Furrows {
 public:
  Furrows(const PictureScene& scene, const Relief& relief);

  // Over the ground that is already painted; only the furrows inside `extent`.
  void paint(const Canvas& canvas, const Eigen::Matrix4f& clip, const Extent& extent,
             const FurrowLook& look) const;

 private:
  struct Vertex {
    Eigen::Vector3f p_D = Eigen::Vector3f::Zero();
    Eigen::Vector2f across_time = Eigen::Vector2f::Zero();  // m from the left end, s
  };
  // A piece of the strips and where it lies, so that pieces out of sight need not be drawn.
  struct Piece {
    Extent extent;
    Eigen::Vector2f heights_D = Eigen::Vector2f::Zero();  // lowest and highest
    double from_s = 0.0;                                  // worked from then on
    std::size_t first = 0;                                // index
    std::size_t count = 0;
  };
  struct Strips {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<Piece> pieces;
  };
  static Strips strips_of(const PictureScene& scene, const Relief& relief);
  explicit Furrows(const Strips& strips, double width_m);

  std::vector<Piece> pieces_;
  double width_m_ = 0.0;
  GlTriangles triangles_;
};

}  // namespace headland
