#include "planner/grid_drivable.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grid_examples.h"
#include "planner/connection.h"
#include "planner/grid_runs.h"
#include "terrains/grid_field.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

GridMap metre_map(const std::string& text, double cell_m) {
  return parse_grid_map(text, cell_m, "drawn");
}

TEST(GridRuns, LeaveStepsBetweenRowsToTurns) {
  const GridMap map = metre_map("....\n....\n", 2.0);
  const std::vector<GridRun> runs =
      work_runs(map, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}});
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].cells, 4);
  EXPECT_EQ(runs[1].cells, 4);
  EXPECT_EQ(runs[1].direction, 0);
  const Pass back = pass_of(map, runs[1]);
  EXPECT_LT((back.points_W[0] - Eigen::Vector2d(8.0, 3.0)).norm(), 1e-12);
  EXPECT_LT((back.points_W[1] - Eigen::Vector2d(0.0, 3.0)).norm(), 1e-12);
}

TEST(GridRuns, WorkEachCellOnceByTheLongestStraightPiece) {
  // Along the row below, up through the one above and back down: the way back works nothing.
  const GridMap map = metre_map("#.##\n#.##\n....\n", 1.0);
  const std::vector<GridRun> runs =
      work_runs(map, {{0, 0}, {1, 0}, {1, 1}, {1, 2}, {1, 1}, {1, 0}, {2, 0}, {3, 0}});
  std::vector<WorkedCell> worked(map.blocked.size());
  int cells = 0;
  for (const GridRun& run : runs) {
    add_worked(map, run, worked);
    cells += run.cells;
  }
  EXPECT_EQ(cells, free_cell_count(map));
  for (std::size_t i = 0; i < worked.size(); ++i) {
    EXPECT_EQ(unworked_share(worked[i]), map.blocked[i] != 0 ? 1.0 : 0.0);
  }
}

TEST(GridRuns, CountTheShareThatIsLeft) {
  const GridMap map = metre_map("...\n", 2.0);
  std::vector<WorkedCell> worked(3);
  add_worked(map, {{2, 0}, 0, 3, 1.0, 5.5}, worked);  // from the east
  EXPECT_NEAR(unworked_share(worked[2]), 0.5, 1e-12);
  EXPECT_NEAR(unworked_share(worked[1]), 0.0, 1e-12);
  EXPECT_NEAR(unworked_share(worked[0]), 0.25, 1e-12);
  add_worked(map, {{2, 0}, 1, 1, 0.0, 1.0}, worked);  // across
  EXPECT_NEAR(unworked_share(worked[2]), 0.25, 1e-12);
  EXPECT_NEAR(missing_along(worked[2], 2).begin, 0.5, 1e-12);
  EXPECT_NEAR(missing_along(worked[2], 0).end, 0.5, 1e-12);
}

// A map of the paper with the ground to turn on that its vehicle needs.
struct DrivenMap {
  GridMap map;
  Vehicle vehicle;
  Field field;
  GridPlan plan;
};

DrivenMap transplanter_case(const std::string& name) {
  DrivenMap made{example_map(name), load_vehicle("transplanter"), {}, {}};
  made.map.cell_m = made.vehicle.implement.working_width_m;
  made.field = field_of_grid(made.map, grid_margin_m(made.vehicle, {}), name);
  made.plan = plan_named("grid_boustrophedon", grid_request(made.map, "grid_boustrophedon"));
  return made;
}

double deepest_overrun_m(const DrivenMap& made, const Path& path) {
  const FreeSpace space = free_space(made.field, hull_of(made.vehicle));
  double deepest_m = 0.0;
  for (const PathSegment& segment : path.segments) {
    deepest_m = std::max(deepest_m, worst_overrun(space, segment.points).depth_m);
  }
  return deepest_m;
}

TEST(GridDrivable, DrivesAnOpenMapByItsRowsAndUTurnsAlone) {
  const DrivenMap made = transplanter_case("field_A");
  const GridDrive drive = make_grid_path(made.field, made.vehicle, made.map, made.plan, {});
  EXPECT_EQ(drive.plan.passes.size(), 12U);
  EXPECT_EQ(drive.added_passes, 0);
  EXPECT_TRUE(drive.left_out.empty());
  EXPECT_TRUE(drive.unworked.empty());
  EXPECT_EQ(drive.unworked_ratio, 0.0);
  int u_turns = 0;
  int last = -1;
  for (const PathSegment& segment : drive.path.segments) {
    if (segment.kind == PathKind::kUTurn && segment.manoeuvre != last) ++u_turns;
    last = segment.manoeuvre;
  }
  EXPECT_EQ(u_turns, 11);
}

TEST(GridDrivable, WorksAroundWhatIsBlockedWithoutTouchingIt) {
  const DrivenMap made = transplanter_case("field_B");
  const GridDrive drive = make_grid_path(made.field, made.vehicle, made.map, made.plan, {});
  EXPECT_LE(deepest_overrun_m(made, drive.path), kFitTolerance_m);
  EXPECT_GT(drive.added_passes, 0);
  // What the drive is to cover, the path must promise.
  EXPECT_LT(drive.unworked_ratio, 0.01);
}

// Each run of the plan is driven or named, and those named are runs of the plan.
TEST(GridDrivable, NamesTheRunsThatItLeavesOut) {
  const DrivenMap made = transplanter_case("field_C");
  const GridDrive drive = make_grid_path(made.field, made.vehicle, made.map, made.plan, {});
  const std::vector<GridRun> runs = work_runs(made.map, made.plan.cells);
  const auto driven = drive.plan.passes.size() - static_cast<std::size_t>(drive.added_passes);
  EXPECT_EQ(driven + drive.left_out.size(), runs.size());
  EXPECT_FALSE(drive.left_out.empty()) << "nothing to test";
  for (const LeftOutRun& left_out : drive.left_out) {
    EXPECT_FALSE(left_out.why.empty());
    const auto same = [&](const GridRun& run) {
      return run.first == left_out.first && cell_of(run, run.cells - 1) == left_out.last;
    };
    EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), same))
        << left_out.first.column << ' ' << left_out.first.row;
  }
}

// Without ground around the map to turn on, not every cell can be worked.
TEST(GridDrivable, TellsWhatIsNotWorkedAndWhy) {
  DrivenMap made = transplanter_case("field_A");
  made.map = metre_map("......\n......\n......\n..##..\n......\n......\n",
                       made.vehicle.implement.working_width_m);
  made.field = field_of_grid(made.map, 0.0, "walled");
  made.plan = plan_named("grid_boustrophedon", grid_request(made.map, "grid_boustrophedon"));
  const GridDrive drive = make_grid_path(made.field, made.vehicle, made.map, made.plan, {});
  // The hull comes to no corner as near as the implement would have to.
  std::vector<GridCell> corners;
  double sum = 0.0;
  for (const UnworkedCell& cell : drive.unworked) {
    corners.push_back(cell.cell);
    EXPECT_GT(cell.share, kUnworkedShare);
    EXPECT_LT(cell.share, 0.1);
    EXPECT_EQ(cell.why, "the hull comes too near to what is blocked for the implement to reach it");
    sum += cell.share;
  }
  EXPECT_EQ(corners, (std::vector<GridCell>{{0, 0}, {5, 0}, {0, 5}, {5, 5}}));
  EXPECT_GT(drive.unworked_ratio, 0.0);
  EXPECT_LE(sum, drive.unworked_ratio * free_cell_count(made.map) + 1e-9);
}

TEST(GridDrivable, DrivesWholeCellsAndRecordsOverrunsWhereTheyAreAllowed) {
  const DrivenMap made = transplanter_case("field_B");
  PathOptions options;
  options.allow_overrun = true;
  const GridDrive drive = make_grid_path(made.field, made.vehicle, made.map, made.plan, options);
  EXPECT_EQ(drive.added_passes, 0);
  EXPECT_EQ(drive.unworked_ratio, 0.0);
  EXPECT_FALSE(drive.path.violations.empty());
}

TEST(GridDrivable, RefusesAMapWithoutRoomForTheVehicle) {
  DrivenMap made = transplanter_case("field_A");
  made.map = metre_map("..\n..\n", 1.0);
  made.field = field_of_grid(made.map, 0.0, "small");
  made.plan = plan_named("grid_boustrophedon", grid_request(made.map, "grid_boustrophedon"));
  try {
    make_grid_path(made.field, made.vehicle, made.map, made.plan, {});
    ADD_FAILURE() << "made";
  } catch (const PlanInfeasible& refused) {
    EXPECT_NE(std::string(refused.what()).find("transplanter has no room on any"),
              std::string::npos)
        << refused.what();
  }
}

}  // namespace
}  // namespace headland
