#include "render/ground_images.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/map_base.h"

namespace headland {
namespace {

constexpr std::array kClassColours = {colours::kOnce, colours::kTwice, colours::kThrice,
                                      colours::kMissed};

// Class of a cell as an index of kClassColours; -1: none.
int colour_class(const CoverageRaster& coverage, std::size_t cell) {
  if (coverage.times[cell] > 0) return std::min<int>(coverage.times[cell], 3) - 1;
  return coverage.in_field[cell] != 0 ? 3 : -1;
}

// Mean of the classes of a square of cells.
Rgba colour_of(const CoverageRaster& coverage, int column, int row, int step) {
  std::array<double, 3> sum{};
  int coloured = 0;
  int cells = 0;
  for (int j = row; j < std::min(row + step, coverage.rows); ++j) {
    for (int i = column; i < std::min(column + step, coverage.columns); ++i) {
      ++cells;
      const int kind = colour_class(
          coverage, static_cast<std::size_t>(j) * static_cast<std::size_t>(coverage.columns) +
                        static_cast<std::size_t>(i));
      if (kind < 0) continue;
      const Rgba colour = kClassColours[static_cast<std::size_t>(kind)];
      sum[0] += colour.r;
      sum[1] += colour.g;
      sum[2] += colour.b;
      ++coloured;
    }
  }
  const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
  if (coloured == 0) return {0, 0, 0, 0};
  return {byte(sum[0] / coloured), byte(sum[1] / coloured), byte(sum[2] / coloured),
          byte(255.0 * coloured / cells)};
}

}  // namespace

GroundImage draw_relief(const PictureScene& scene, int longest_side_px) {
  constexpr double kMarginShare = 0.06;
  const Extent field = extent_of(scene.field.boundary);
  const Extent wanted =
      overlap(grown(field, kMarginShare * field.size().maxCoeff()), extent_of(scene.terrain));
  const double px_per_m = longest_side_px / wanted.size().maxCoeff();
  const auto pixels = [px_per_m](double m) {
    return std::max(1, static_cast<int>(std::lround(m * px_per_m)));
  };
  Page page;
  page.size_px = {pixels(wanted.size().x()), pixels(wanted.size().y())};
  page.main = {0.0, 0.0, static_cast<double>(page.size_px.x()),
               static_cast<double>(page.size_px.y())};
  MapView view = map_view(scene, page);
  view.camera = {page.main, wanted, px_per_m};
  const GlContext context;
  const GlFrame frame(page.size_px.x(), page.size_px.y(), colours::kPaper);
  const MapGround ground(scene, view, CoverageClasses{}, {}, colours::kGround);
  return {wanted,
          frame.draw([&](const Canvas& canvas) { paint_map_ground(canvas, view, ground); })};
}

GroundImage coverage_image(const CoverageRaster& coverage, int longest_side_px) {
  const int longest = std::max(coverage.columns, coverage.rows);
  const int step = std::max(1, (longest + longest_side_px - 1) / longest_side_px);
  GroundImage ground;
  ground.image.width = (coverage.columns + step - 1) / step;
  ground.image.height = (coverage.rows + step - 1) / step;
  const Eigen::Vector2d size(ground.image.width, ground.image.height);
  ground.extent = {coverage.origin_W, coverage.origin_W + coverage.cell_m * step * size};
  // Rows from north to south.
  for (int y = ground.image.height - 1; y >= 0; --y) {
    for (int x = 0; x < ground.image.width; ++x) {
      const Rgba colour = colour_of(coverage, x * step, y * step, step);
      ground.image.rgba.insert(ground.image.rgba.end(), {colour.r, colour.g, colour.b, colour.a});
    }
  }
  return ground;
}

}  // namespace headland
