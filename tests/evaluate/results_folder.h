// A folder for what a test writes, and a small path and run to write.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include "evaluate/atomic_file.h"
#include "planner/path.h"
#include "sim/run_record.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland::test {

namespace fs = std::filesystem;

const GeoFrame kLocal;
const GeoFrame kOnEarth{true, 43.9241, -93.9751};

class ResultsFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    write_together(folder_, {{name, text}});
    return folder_ / name;
  }

  std::set<std::string> names_in_folder() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  const Vehicle vehicle_ = load_vehicle("transplanter");
  const fs::path folder_ = fs::path(::testing::TempDir()) /
                           ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

inline Field field_on(const GeoFrame& frame) {
  Field field;
  field.name = "square";
  field.boundary = {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}};
  field.frame = frame;
  return field;
}

// The point a step [m] along a circle after `from`, headings within (-pi, pi].
inline PathPoint next_on_circle(const PathPoint& from, double step_m, double curvature_per_m) {
  const double turn_rad = step_m * curvature_per_m;
  const double along_rad = from.heading_rad + 0.5 * turn_rad;
  return {from.p_W + step_m * Eigen::Vector2d(std::cos(along_rad), std::sin(along_rad)),
          std::remainder(from.heading_rad + turn_rad, 2.0 * std::numbers::pi), curvature_per_m};
}

inline Path some_path() {
  Path path;
  PathSegment swath{PathKind::kSwath, Gear::kForward, true, 0, {}};
  swath.points = {{{-12.3456789, 7.0}, 3.123456789012, 0.25}};
  for (int i = 0; i < 2; ++i) {
    swath.points.push_back(next_on_circle(swath.points.back(), 0.25, 0.25));
  }
  PathSegment turn{PathKind::kUTurn, Gear::kReverse, false, 1, {}};
  turn.points = {swath.points.back(), next_on_circle(swath.points.back(), -0.5, -0.25)};
  path.segments = {swath, turn};
  path.violations = {{{-12.0, 7.0}, 1, 0.375, "hull beyond the boundary"}};
  return path;
}

inline RunRecord some_run() {
  RunRecord run;
  run.outcome = Outcome::kStuck;
  run.outcome_detail = "wheels spin, at \"a\" place";
  run.duration_s = 12.5;
  run.distance_m = 8.25;
  run.soc_end = 0.9375;
  run.energy.battery_j = 1234.5678;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) run.energy.cause_j[i] = 0.5 + double(i);
  run.peaks.slip = {0.75, 3.25, {1.5, -2.5}};
  run.peaks.belly_contacts = 3;
  run.peaks.motor_clipped_s = 1.75;
  for (int i = 0; i < 3; ++i) {
    RunSample sample;
    sample.time_s = 0.1 * i;
    sample.p_WB = {0.5 * i, 1.0, 0.25};
    sample.wheel_load_n = {1000.5, 2000.0, 3000.0, 4000.0};
    sample.segment = i / 2;
    sample.implement_down = i < 2;
    run.samples.push_back(sample);
    run.footprints.push_back({{0.5 * i, 1.0}, {0.5 * i, -1.0}, 0.5 * i, 0.25 * i, i == 0});
  }
  SegmentRecord segment;
  segment.segment = 1;
  segment.duration_s = 4.0;
  segment.distance_m = 2.0;
  segment.energy = run.energy;
  segment.cross_track_sum_m3 = 0.02;  // 0.1 m rms over 2 m
  run.segments = {segment};
  return run;
}

}  // namespace headland::test
