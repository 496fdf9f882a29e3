// What holds of the audit of any path in any field.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "evaluate/audit.h"
#include "planner/arcs.h"
#include "terrains/field_source.h"
#include "tests/terrains/random_ring.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

constexpr double kAuditedCell_m = 0.5;

const Vehicle& audited_vehicle() {
  static const Vehicle vehicle = load_vehicle("transplanter");
  return vehicle;
}

// A field of any shape, often with a hole, and a path of a few lines anywhere in and around it.
struct AuditedCase {
  Field field;
  std::vector<PathLine> lines;
};

AuditedCase any_audited_case() {
  AuditedCase made;
  made.field.boundary = any_ring();
  if (*rc::gen::arbitrary<bool>()) {
    made.field.holes.push_back({{-4, -4}, {-4, 4}, {4, 4}, {4, -4}});
  }
  const int lines = *rc::gen::inRange(1, 4);
  for (int i = 0; i < lines; ++i) {
    PathLine line;
    line.implement_down = *rc::gen::arbitrary<bool>();
    const int points = *rc::gen::inRange(2, 5);
    for (int k = 0; k < points; ++k) {
      line.points_W.emplace_back(any_number(-110.0, 110.0), any_number(-110.0, 110.0));
    }
    made.lines.push_back(std::move(line));
  }
  // A path without length is refused.
  const std::vector<Eigen::Vector2d>& first = made.lines.front().points_W;
  RC_PRE((first[1] - first[0]).norm() > 1.0);
  return made;
}

Audit audit_of(const AuditedCase& of) {
  return audit_path(of.field, audited_vehicle(), of.lines, kAuditedCell_m);
}

const AuditTotals& totals(const Audit& audit, AuditFault fault) {
  return audit.totals[static_cast<std::size_t>(fault)];
}

// The same wherever the field lies and however it is turned, to rounding.
TEST(AuditProperties, MovingFieldAndPathChangesNothing) {
  EXPECT_TRUE(rc::check([] {
    const AuditedCase here = any_audited_case();
    const Eigen::Rotation2Dd turn(any_number(-3.0, 3.0));
    const Eigen::Vector2d shift(any_number(-500.0, 500.0), any_number(-500.0, 500.0));
    const auto moved = [&](const Eigen::Vector2d& p_W) -> Eigen::Vector2d {
      return turn * p_W + shift;
    };
    AuditedCase there = here;
    for (Eigen::Vector2d& p_W : there.field.boundary) p_W = moved(p_W);
    for (Ring& hole : there.field.holes) {
      for (Eigen::Vector2d& p_W : hole) p_W = moved(p_W);
    }
    for (PathLine& line : there.lines) {
      for (Eigen::Vector2d& p_W : line.points_W) p_W = moved(p_W);
    }
    const Audit a = audit_of(here);
    const Audit b = audit_of(there);
    RC_ASSERT(std::abs(a.length_m - b.length_m) < 1e-6);
    RC_ASSERT(a.gear_changes == b.gear_changes);
    for (const AuditFault fault : kEveryAuditFault) {
      // A state on the very edge may fall to either side.
      const double edge_m = 4.0 * kPathSpacing_m;
      RC_ASSERT(std::abs(totals(a, fault).length_m - totals(b, fault).length_m) <= edge_m);
      RC_ASSERT((totals(a, fault).places > 0) == (totals(b, fault).places > 0) ||
                totals(a, fault).states + totals(b, fault).states <= 4);
    }
  }));
}

// Cut into lines that join, a path is the same path.
TEST(AuditProperties, WhereLinesAreCutDoesNotMatter) {
  EXPECT_TRUE(rc::check([] {
    const AuditedCase whole = any_audited_case();
    AuditedCase cut = whole;
    cut.lines.clear();
    for (const PathLine& line : whole.lines) {
      const auto at = static_cast<std::size_t>(
          *rc::gen::inRange<int>(0, static_cast<int>(line.points_W.size())));
      const auto middle = line.points_W.begin() + static_cast<std::ptrdiff_t>(at);
      cut.lines.push_back({{line.points_W.begin(), middle + 1}, line.implement_down, false});
      if (middle + 1 == line.points_W.end()) continue;
      cut.lines.push_back({{middle, line.points_W.end()}, line.implement_down, true});
    }
    const Audit a = audit_of(whole);
    const Audit b = audit_of(cut);
    RC_ASSERT(a.states == b.states);
    RC_ASSERT(a.length_m == b.length_m);
    RC_ASSERT(a.places.size() == b.places.size());
    RC_ASSERT(a.coverage.covered_m2 == b.coverage.covered_m2);
    RC_ASSERT(a.coverage.overlap_m2 == b.coverage.overlap_m2);
  }));
}

// Sums of places are the totals, worked and missed ground add up to the field, and patches are
// parts of what is missed or overlapped.
TEST(AuditProperties, PartsAddUp) {
  EXPECT_TRUE(rc::check([] {
    const AuditedCase of = any_audited_case();
    const Audit audit = audit_of(of);
    std::array<AuditTotals, kEveryAuditFault.size()> sums;
    for (const AuditPlace& place : audit.places) {
      AuditTotals& sum = sums[static_cast<std::size_t>(place.fault)];
      ++sum.places;
      sum.states += place.states;
      sum.length_m += place.length_m;
      RC_ASSERT(place.from_m >= 0.0);
      RC_ASSERT(place.from_m <= audit.length_m + 1e-9);
      RC_ASSERT(place.worst > 0.0);
    }
    for (const AuditFault fault : kEveryAuditFault) {
      const AuditTotals& sum = sums[static_cast<std::size_t>(fault)];
      RC_ASSERT(sum.places == totals(audit, fault).places);
      RC_ASSERT(sum.states == totals(audit, fault).states);
      RC_ASSERT(std::abs(sum.length_m - totals(audit, fault).length_m) < 1e-6);
    }
    RC_ASSERT(static_cast<std::size_t>(totals(audit, AuditFault::kJump).places) < of.lines.size());
    const CoverageFigures& coverage = audit.coverage;
    RC_ASSERT(std::abs(coverage.covered_m2 + coverage.missed_m2 - coverage.workable_m2) < 1e-6);
    double missed_m2 = 0.0;
    for (const GroundPatch& patch : audit.missed) missed_m2 += patch.area_m2;
    RC_ASSERT(missed_m2 <= coverage.missed_m2 + 1e-6);
    double overlapped_m2 = 0.0;
    for (const GroundPatch& patch : audit.overlapped) {
      overlapped_m2 += patch.area_m2;
      RC_ASSERT(inside_ring(of.field.boundary, patch.p_W));
    }
    // Every further pass counts in the figure, and once in a patch.
    RC_ASSERT(overlapped_m2 <= coverage.overlap_m2 + 1e-6);
  }));
}

// Against a check of its own: the corners of the hull and their distances to the edges. In a
// convex field nothing of the hull is further out than its furthest corner.
TEST(AuditProperties, FindsWhatCornersOfTheHullFind) {
  EXPECT_TRUE(rc::check([] {
    AuditedCase of;
    const double half_m = any_number(15.0, 60.0);
    of.field.boundary = {
        {-half_m, -half_m}, {half_m, -half_m}, {0.7 * half_m, half_m}, {-half_m, 0.8 * half_m}};
    of.lines.push_back({{{any_number(-80.0, 80.0), any_number(-80.0, 80.0)},
                         {any_number(-80.0, 80.0), any_number(-80.0, 80.0)}},
                        true,
                        false});
    const std::vector<Eigen::Vector2d>& line = of.lines[0].points_W;
    RC_PRE((line[1] - line[0]).norm() > 1.0);
    const Audit audit = audit_of(of);
    const Vehicle& vehicle = audited_vehicle();
    const Eigen::Vector2d ahead = (line[1] - line[0]).normalized();
    const Eigen::Vector2d left(-ahead.y(), ahead.x());
    const double front_m = vehicle.body.length_m - vehicle.body.rear_overhang_m;
    double deepest_m = 0.0;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < audit.states; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(audit.states - 1);
      const Eigen::Vector2d p_W = line[0] + t * (line[1] - line[0]);
      double depth_m = 0.0;
      for (const double along_m : {front_m, -vehicle.body.rear_overhang_m}) {
        for (const double side_m : {0.5 * vehicle.body.width_m, -0.5 * vehicle.body.width_m}) {
          depth_m = std::max(depth_m,
                             -field_clearance_m(of.field, p_W + along_m * ahead + side_m * left));
        }
      }
      deepest_m = std::max(deepest_m, depth_m);
      if (depth_m > 0.01) ++outside;  // kFitTolerance_m
    }
    const AuditTotals& found = totals(audit, AuditFault::kOutside);
    RC_ASSERT(found.states + 1 >= outside);
    RC_ASSERT(found.states <= outside + 1);
    if (deepest_m > 0.011) RC_ASSERT(std::abs(found.worst - deepest_m) < 1e-6);
  }));
}

}  // namespace
}  // namespace headland
