#include "planner/worked_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/arcs.h"
#include "tests/planner/field_shapes.h"

namespace headland {
namespace {

// Cells are in or out as their centres are: along a line half a cell of it may be told wrongly.
double slack_m2(const WorkedGround& ground, double edges_m) { return ground.cell_m * edges_m; }

std::ptrdiff_t to_work_cells(const WorkedGround& ground) {
  return std::ranges::count(ground.cells, GroundState::kToWork);
}

TEST(WorkedGround, IsTheFieldWithoutHolesAndObstacles) {
  Field field = field_of("square", rectangle_ring(0, 0, 40, 30));
  field.holes.push_back(reversed(rectangle_ring(10, 10, 20, 15)));
  field.obstacles.push_back({ObstacleKind::kTree, {30, 20}, 2.0, 5.0});
  const WorkedGround ground = ground_to_work(field);
  const double area_m2 = static_cast<double>(to_work_cells(ground)) * ground.cell_m * ground.cell_m;
  EXPECT_NEAR(area_m2, 40.0 * 30.0 - 50.0 - kPi * 4.0, slack_m2(ground, 140 + 30 + 13));
  EXPECT_EQ(state_at(ground, {15, 12}), GroundState::kOutside);
  EXPECT_EQ(state_at(ground, {30, 21}), GroundState::kOutside);
  EXPECT_EQ(state_at(ground, {-5, 300}), GroundState::kOutside);
  EXPECT_EQ(state_at(ground, {5, 5}), GroundState::kToWork);
}

TEST(WorkedGround, IsFinerOnSmallFields) {
  EXPECT_EQ(ground_to_work(field_of("small", rectangle_ring(0, 0, 40, 30))).cell_m,
            kFineGroundCell_m);
  EXPECT_EQ(ground_to_work(field_of("large", rectangle_ring(0, 0, 400, 300))).cell_m,
            kGroundCell_m);
}

TEST(WorkedGround, CountsWhatIsWorkedOnce) {
  WorkedGround ground = ground_to_work(field_of("square", rectangle_ring(0, 0, 40, 30)));
  const std::vector<Eigen::Vector2d> line{{5, 10}, {25, 10}};
  const Eigen::Vector2d half_bar(0.0, 2.0);
  const Quadrangle strip = between_bars(line[0], line[1], half_bar, half_bar);
  EXPECT_NEAR(to_work_m2(ground, strip), 80.0, slack_m2(ground, 48));
  EXPECT_NEAR(work_along(ground, line, 4.0), 80.0, slack_m2(ground, 48));
  EXPECT_EQ(state_at(ground, {10, 11}), GroundState::kWorked);
  EXPECT_EQ(work_along(ground, line, 4.0), 0.0);
  // Half of it lies beside the first, a quarter outside the field.
  EXPECT_NEAR(work_along(ground, {{5, 14}, {45, 14}}, 4.0), 35.0 * 4.0, slack_m2(ground, 78));
}

TEST(WorkedGround, IsAllWorkedBySwathsThatCoverIt) {
  const Field field = field_of("square", rectangle_ring(0, 0, 40, 30));
  WorkedGround ground = ground_to_work(field);
  SwathGrid grid{0.0, 5.0, 10.0, 3, {{0, 0.0, 40.0}, {2, 0.0, 40.0}}};
  work_swaths(ground, grid, 10.0);
  EXPECT_NEAR(to_work_m2(ground), 400.0, slack_m2(ground, 100)) << "the middle line has no swath";
  std::vector<std::size_t> newly;
  const Eigen::Vector2d half_bar(0.0, 5.0);
  const double middle_m2 =
      work(ground, between_bars({0, 15}, {40, 15}, half_bar, half_bar), &newly);
  EXPECT_EQ(to_work_m2(ground), 0.0);
  unwork(ground, newly);
  EXPECT_NEAR(to_work_m2(ground), middle_m2, 1e-9) << "the cells told are those worked";
}

// On an arc of radius R the ends of a bar x behind the axle run on radii hypot(R +- w / 2, x).
TEST(WorkedGround, ABarBehindATurningAxleSwingsOut) {
  constexpr double kRadius_m = 5.0;
  constexpr double kBehind_m = 2.0;
  constexpr double kWidth_m = 6.0;
  constexpr double kTurn_rad = 2.0;
  const Field field = field_of("square", rectangle_ring(0, 0, 40, 40));
  const Pose begin{{20.0, 15.0}, 0.0};  // about (20, 20)
  const std::vector<PathPoint> points =
      sample(begin, {{kTurn_rad * kRadius_m, 1.0 / kRadius_m}}, kPathSpacing_m)[0].points;
  WorkedGround ground = ground_to_work(field);
  const double rim_m = 2.0 * (kWidth_m + kTurn_rad * kRadius_m);
  EXPECT_NEAR(work_driven(ground, points, -kBehind_m, kWidth_m), kTurn_rad * kRadius_m * kWidth_m,
              slack_m2(ground, rim_m));
  const Eigen::Vector2d middle_W(20.0, 20.0);
  const double outer_m = std::hypot(kRadius_m + 0.5 * kWidth_m, kBehind_m);
  const double inner_m = std::hypot(kRadius_m - 0.5 * kWidth_m, kBehind_m);
  const Eigen::Vector2d aside = direction_of(-0.5 * kPi + 0.5 * kTurn_rad);
  const double cell_m = 1.5 * ground.cell_m;
  EXPECT_EQ(state_at(ground, middle_W + (outer_m - cell_m) * aside), GroundState::kWorked);
  EXPECT_EQ(state_at(ground, middle_W + (outer_m + cell_m) * aside), GroundState::kToWork);
  EXPECT_EQ(state_at(ground, middle_W + (inner_m - cell_m) * aside), GroundState::kToWork);
  // Negative control: a bar whose middle follows the line works inside of that.
  WorkedGround followed = ground_to_work(field);
  std::vector<Eigen::Vector2d> line_W;
  for (const PathPoint& point : points) line_W.push_back(point.p_W);
  work_along(followed, line_W, kWidth_m);
  EXPECT_EQ(state_at(followed, middle_W + (inner_m - cell_m) * aside), GroundState::kWorked);
}

}  // namespace
}  // namespace headland
