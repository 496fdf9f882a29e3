#include "render/furrows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "render/sight.h"

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

constexpr double kSpacing_m = 0.45;  // from furrow to furrow, about
constexpr double kStep_m = 0.3;      // between footprints that are drawn
constexpr double kAcross_m = 1.0;    // between points across, so that wide strips lie on the ground
constexpr double kLift_m = 0.03;
constexpr std::size_t kPieceSteps = 100;

Eigen::Vector3f box_corner(const Point2& p_W, float height_D) {
  return {static_cast<float>(p_W.x()), static_cast<float>(p_W.y()), height_D};
}

bool is_finite(const FootprintSample& footprint) {
  return footprint.left_W.allFinite() && footprint.right_W.allFinite();
}

}  // namespace

Furrows::Strips Furrows::strips_of(const PictureScene& scene, const Relief& relief) {
  const double width_m = scene.vehicle.implement.working_width_m;
  const int columns = std::clamp(static_cast<int>(std::ceil(width_m / kAcross_m)), 1, 60);
  Strips strips;
  bool joined = false;
  const auto& footprints = scene.run.footprints;
  const auto add_row = [&](const FootprintSample& footprint) {
    Piece& piece = strips.pieces.back();
    for (int i = 0; i <= columns; ++i) {
      const double share = static_cast<double>(i) / columns;
      const Point2 p_W = footprint.left_W + share * (footprint.right_W - footprint.left_W);
      const Eigen::Vector3d p_D =
          on_ground(scene.terrain, relief, p_W) + Eigen::Vector3d(0.0, 0.0, kLift_m);
      strips.vertices.push_back(
          {p_D.cast<float>(),
           {static_cast<float>(share * width_m), static_cast<float>(footprint.time_s)}});
      piece.extent.low = piece.extent.low.cwiseMin(p_W);
      piece.extent.high = piece.extent.high.cwiseMax(p_W);
      piece.heights_D = {std::min(piece.heights_D.x(), static_cast<float>(p_D.z())),
                         std::max(piece.heights_D.y(), static_cast<float>(p_D.z()))};
    }
  };
  const auto start_piece = [&](const FootprintSample& first) {
    constexpr float kNone = std::numeric_limits<float>::infinity();
    strips.pieces.push_back(
        {{first.left_W, first.left_W}, {kNone, -kNone}, first.time_s, strips.indices.size(), 0});
  };
  const FootprintSample* last = nullptr;
  std::size_t steps = 0;
  for (std::size_t k = 0; k < footprints.size(); ++k) {
    const FootprintSample& footprint = footprints[k];
    if (!is_finite(footprint)) {
      joined = false;
      continue;
    }
    if (footprint.starts_strip) joined = false;
    const bool ends = k + 1 == footprints.size() || footprints[k + 1].starts_strip;
    if (joined && !ends && (footprint.left_W - last->left_W).norm() < kStep_m &&
        (footprint.right_W - last->right_W).norm() < kStep_m) {
      continue;
    }
    if (!joined || steps % kPieceSteps == 0) {
      // A piece goes on from where the one before it ended.
      start_piece(joined ? *last : footprint);
      if (joined) add_row(*last);
    }
    ++steps;
    add_row(footprint);
    if (joined) {
      const auto row = static_cast<std::uint32_t>(columns + 1);
      const auto first = static_cast<std::uint32_t>(strips.vertices.size()) - 2 * row;
      for (std::uint32_t i = 0; i + 1 < row; ++i) {
        const std::uint32_t a = first + i;
        for (const std::uint32_t v : {a, a + 1, a + row, a + 1, a + row + 1, a + row}) {
          strips.indices.push_back(v);
        }
      }
      strips.pieces.back().count = strips.indices.size() - strips.pieces.back().first;
    }
    joined = true;
    last = &footprint;
  }
  return strips;
}

Furrows::Furrows(const PictureScene& scene, const Relief& relief)
    : Furrows(strips_of(scene, relief), scene.vehicle.implement.working_width_m) {}

Furrows::Furrows(const Strips& strips, double width_m)
    : pieces_(strips.pieces),
      width_m_(width_m),
      triangles_(std::as_bytes(std::span(strips.vertices)), sizeof(Vertex),
                 std::array<GlAttribute, 2>{{{3, GL_FLOAT, offsetof(Vertex, p_D)},
                                             {2, GL_FLOAT, offsetof(Vertex, across_time)}}},
                 strips.indices) {}

void Furrows::paint(const Canvas& canvas, const Eigen::Matrix4f& clip, const Extent& extent,
                    const FurrowLook& look) const {
  const GlProgram& program = canvas.programs.furrow;
  program.use();
  program.set("clip_from_D", clip);
  program.set("now", static_cast<float>(look.now_s));
  // A whole number of furrows from one end to the other.
  const double furrows = std::max(1.0, std::round(width_m_ / kSpacing_m));
  program.set("spacing", static_cast<float>(std::max(width_m_, 0.01) / furrows));
  program.set("width", static_cast<float>(width_m_));
  program.set("fade_centre", Eigen::Vector2f(look.centre_W.cast<float>()));
  program.set("fade_from_to", Eigen::Vector2f(static_cast<float>(look.fade_from_m),
                                              static_cast<float>(look.fade_to_m)));
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  // The strips' corners lie on the ground, what is between them not quite.
  glPolygonOffset(-3.0F, -3.0F);
  const Sight sight(clip);
  for (const Piece& piece : pieces_) {
    if (piece.from_s > look.now_s) continue;
    const bool apart = (piece.extent.high.array() < extent.low.array()).any() ||
                       (piece.extent.low.array() > extent.high.array()).any();
    if (apart || sight.misses_box(box_corner(piece.extent.low, piece.heights_D.x()),
                                  box_corner(piece.extent.high, piece.heights_D.y()))) {
      continue;
    }
    triangles_.draw(piece.first, piece.count);
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace headland
