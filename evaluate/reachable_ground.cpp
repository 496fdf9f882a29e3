#include "evaluate/reachable_ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "planner/free_space.h"
#include "planner/hull.h"

namespace headland {
namespace {

using Eigen::Vector2d;

struct Cells {
  const CoverageRaster& raster;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
           static_cast<std::size_t>(column);
  }
  Vector2d centre_W(int column, int row) const {
    return raster.origin_W + raster.cell_m * Vector2d(column + 0.5, row + 0.5);
  }
};

// Cells by the connected ground they belong to, 0: none; grounds are counted from 1.
struct Grounds {
  std::vector<int> of_cell;
  std::vector<std::size_t> sizes{0};
};

// Where a disc may be, grown by what the raster cannot tell.
Grounds connected_grounds(const CoverageRaster& raster, const FreeSpace& space, double radius_m) {
  const Cells cells{raster};
  const double surely_m = radius_m - std::numbers::sqrt2 / 2.0 * raster.cell_m;
  constexpr int kFree = -1;
  Grounds grounds;
  grounds.of_cell.assign(raster.times.size(), 0);
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      if (disc_fits(space, cells.centre_W(column, row), surely_m)) {
        grounds.of_cell[cells.index(column, row)] = kFree;
      }
    }
  }
  std::vector<std::pair<int, int>> open;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      if (grounds.of_cell[cells.index(column, row)] != kFree) continue;
      const int ground = static_cast<int>(grounds.sizes.size());
      grounds.sizes.push_back(0);
      const auto take = [&](int c, int r) {
        if (c < 0 || r < 0 || c >= raster.columns || r >= raster.rows) return;
        int& of_cell = grounds.of_cell[cells.index(c, r)];
        if (of_cell != kFree) return;
        of_cell = ground;
        ++grounds.sizes.back();
        open.emplace_back(c, r);
      };
      take(column, row);
      while (!open.empty()) {
        const auto [c, r] = open.back();
        open.pop_back();
        take(c + 1, r);
        take(c - 1, r);
        take(c, r + 1);
        take(c, r - 1);
      }
    }
  }
  return grounds;
}

int ground_at(const Grounds& grounds, const CoverageRaster& raster, const Vector2d& p_W) {
  const Vector2d cell = (p_W - raster.origin_W) / raster.cell_m;
  const int column = static_cast<int>(std::floor(cell.x()));
  const int row = static_cast<int>(std::floor(cell.y()));
  if (column < 0 || row < 0 || column >= raster.columns || row >= raster.rows) return 0;
  return grounds.of_cell[Cells{raster}.index(column, row)];
}

// The ground nearest to the entry, which is a gate in the boundary; the largest one without it.
int main_ground(const Grounds& grounds, const CoverageRaster& raster, const Field& field) {
  if (!field.entry_W) {
    return static_cast<int>(std::ranges::max_element(grounds.sizes) - grounds.sizes.begin());
  }
  const Cells cells{raster};
  int nearest = 0;
  double nearest_m2 = std::numeric_limits<double>::infinity();
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      const int ground = grounds.of_cell[cells.index(column, row)];
      const double away_m2 = (cells.centre_W(column, row) - *field.entry_W).squaredNorm();
      if (ground == 0 || away_m2 >= nearest_m2) continue;
      nearest_m2 = away_m2;
      nearest = ground;
    }
  }
  return nearest;
}

void add_four_ways(const Vector2d& edge, std::vector<double>& headings_rad) {
  const double along_rad = std::atan2(edge.y(), edge.x());
  for (int quarter = 0; quarter < 4; ++quarter) {
    headings_rad.push_back(along_rad + quarter * std::numbers::pi / 2.0);
  }
}

// Edges with a part within `within_m` of a place, as directions.
std::vector<double> headings_near(const FreeSpace& space, const Vector2d& p_W, double within_m) {
  std::vector<double> headings_rad;
  for (const FreeSpace::Edge& edge : space.edges) {
    const Vector2d along = edge.b_W - edge.a_W;
    const double t = std::clamp((p_W - edge.a_W).dot(along) / along.squaredNorm(), 0.0, 1.0);
    if ((edge.a_W + t * along - p_W).squaredNorm() > within_m * within_m) continue;
    add_four_ways(along, headings_rad);
  }
  for (const Obstacle& obstacle : space.obstacles) {
    if (obstacle_gap_m(obstacle, p_W) > within_m) continue;
    add_four_ways(nearest_of(obstacle, p_W) - p_W, headings_rad);
  }
  return headings_rad;
}

class Reach {
 public:
  Reach(const CoverageRaster& raster, const Field& field, const Vehicle& vehicle,
        double clearance_m)
      : raster_(raster),
        space_(free_space(field, hull_of(vehicle))),
        clearance_m_(clearance_m),
        grounds_(connected_grounds(raster, space_, space_.hull.half_width_m + clearance_m)),
        main_(main_ground(grounds_, raster, field)) {
    const double half_m = space_.hull.bar_half_width_m;
    const int steps = std::max(1, static_cast<int>(std::ceil(half_m / kReachStep_m)));
    asides_m_.push_back(0.0);
    for (int step = 1; step <= steps; ++step) {
      asides_m_.push_back(half_m * step / steps);
      asides_m_.push_back(-half_m * step / steps);
    }
  }

  bool covers(const Vector2d& p_W) const {
    for (int i = 0; i < kReachHeadings; ++i) {
      if (covers_heading(p_W, 2.0 * std::numbers::pi * i / kReachHeadings)) return true;
    }
    const double within_m = space_.reach_with_bar_m + space_.hull.bar_half_width_m + clearance_m_;
    return std::ranges::any_of(headings_near(space_, p_W, within_m), [&](double heading_rad) {
      return covers_heading(p_W, heading_rad);
    });
  }

 private:
  bool covers_heading(const Vector2d& p_W, double heading_rad) const {
    const Vector2d ahead = direction_of(heading_rad);
    const Vector2d left = left_of(heading_rad);
    const double middle_m = 0.5 * (space_.hull.front_m - space_.hull.rear_m);
    return std::ranges::any_of(asides_m_, [&](double aside_m) {
      const Pose pose{p_W - space_.hull.bar_x_m * ahead + aside_m * left, heading_rad};
      return ground_at(grounds_, raster_, pose.p_W + middle_m * ahead) == main_ &&
             fits(space_, pose, clearance_m_ - kFitTolerance_m) && works_inside(space_, pose, 0.0);
    });
  }

  const CoverageRaster& raster_;
  FreeSpace space_;
  double clearance_m_;
  Grounds grounds_;
  int main_;
  std::vector<double> asides_m_;
};

}  // namespace

CoverageRaster reachable_part(CoverageRaster raster, const Field& field, const Vehicle& vehicle,
                              double clearance_m) {
  const Reach reach(raster, field, vehicle, clearance_m);
  const Cells cells{raster};
  std::vector<std::uint8_t> reachable(raster.in_field.size(), 0);
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      const std::size_t cell = cells.index(column, row);
      if (raster.in_field[cell] == 0) continue;
      // What was covered can be reached, whether a pose is found for it or not.
      reachable[cell] = raster.times[cell] > 0 || reach.covers(cells.centre_W(column, row)) ? 1 : 0;
    }
  }
  raster.in_field = std::move(reachable);
  return raster;
}

}  // namespace headland
