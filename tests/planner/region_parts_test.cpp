// Parts filtered and merged: nothing is lost unseen, and every part can be swept.
#include "planner/region_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "planner/part_sweep.h"
#include "planner/region_generator.h"
#include "terrains/field_source.h"
#include "tests/planner/field_shapes.h"
#include "tests/planner/random_ground.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

using testing::HasSubstr;

constexpr double kSum_m2 = 5e-3;  // GEOS rounds points to 1e-6 m, edges are some 1000 m in all

PolygonSet notched_ground() {
  // A field with a spur of 2 m by 1 m at its upper edge.
  return {{PolygonPart{
      {{0, 0}, {100, 0}, {100, 50}, {62, 50}, {62, 51}, {60, 51}, {60, 50}, {0, 50}}, {}}}};
}

int line_sum(const RegionParts& parts, double width_m) {
  int sum = 0;
  for (const RegionPart& part : parts.parts) {
    sum += sweep_line_count(part.outline_W, part.sweep_rad, width_m);
  }
  return sum;
}

TEST(SmallParts, AreDroppedAndTheirGroundIsReported) {
  PartsOptions options;
  options.width_m = 10.0;
  options.least_m2 = 5.0;
  const RegionParts parts = region_parts(notched_ground(), options);
  ASSERT_EQ(parts.parts.size(), 1U);
  ASSERT_EQ(parts.dropped_W.size(), 1U);
  EXPECT_NEAR(dropped_m2(parts), 2.0, kSum_m2);
  EXPECT_NEAR(area_m2(parts), 5000.0, kSum_m2);
  options.least_m2 = 1.0;
  EXPECT_TRUE(region_parts(notched_ground(), options).dropped_W.empty());
}

TEST(SmallParts, GoToANeighbourInsteadIfAsked) {
  PartsOptions options;
  options.width_m = 10.0;
  options.least_m2 = 5.0;
  options.small = SmallParts::kMerge;
  const RegionParts parts = region_parts(notched_ground(), options);
  ASSERT_EQ(parts.parts.size(), 1U);
  EXPECT_TRUE(parts.dropped_W.empty());
  EXPECT_NEAR(area_m2(parts), 5002.0, kSum_m2);
  EXPECT_TRUE(is_swept_whole(parts.parts[0].outline_W, parts.parts[0].sweep_rad));
}

TEST(MergeParts, MakesOneOfWhatOneDirectionServes) {
  // Two rectangles side by side, swept alike: five lines instead of ten.
  const PolygonPart ground{rectangle_ring(0, 0, 200, 50), {}};
  const auto halves = cut_apart(ground, std::vector<Polyline>{{{100, 0}, {100, 50}}});
  ASSERT_EQ(halves.size(), 2U);
  RegionParts parts;
  for (const PolygonPart& half : halves) parts.parts.push_back({half.outer, 0.0});
  merge_parts(parts, 10.0);
  ASSERT_EQ(parts.parts.size(), 1U);
  EXPECT_NEAR(signed_area_m2(parts.parts[0].outline_W), 10000.0, kSum_m2);
  EXPECT_EQ(line_sum(parts, 10.0), 5);
}

TEST(MergeParts, LeavesWhatItWouldNotServe) {
  // A long arm across a wide one: together they would need 20 lines instead of 5 + 5.
  const PolygonPart ground{{{0, 0}, {200, 0}, {200, 50}, {50, 50}, {50, 200}, {0, 200}}, {}};
  const auto arms = cut_apart(ground, std::vector<Polyline>{{{50, 50}, {0, 50}}});
  ASSERT_EQ(arms.size(), 2U);
  RegionParts parts;
  for (const PolygonPart& arm : arms) {
    parts.parts.push_back({arm.outer, longest_edge_rad(arm.outer)});
  }
  merge_parts(parts, 10.0);
  EXPECT_EQ(parts.parts.size(), 2U);
}

TEST(MergeParts, NeverClosesAroundAHole) {
  PartsOptions options;
  options.width_m = 5.0;
  options.merge = true;
  const PolygonSet ground{
      {PolygonPart{rectangle_ring(0, 0, 100, 100), {reversed(rectangle_ring(40, 40, 60, 60))}}}};
  for (const Decomposition decomposition :
       {Decomposition::kConvex, Decomposition::kTrapezoidal, Decomposition::kBoustrophedon}) {
    options.decomposition = decomposition;
    const RegionParts parts = region_parts(ground, options);
    EXPECT_GE(parts.parts.size(), 2U);
    EXPECT_LE(parts.parts.size(), 4U);
    EXPECT_NEAR(area_m2(parts), 9600.0, kSum_m2);
  }
}

TEST(RegionParts, OfAnyGroundKeepItsAreaAndAreSweptWhole) {
  EXPECT_TRUE(rc::check([] {
    const PolygonPart ground = any_ground(3);
    PartsOptions options;
    options.width_m = any_number(1.0, 10.0);
    options.least_m2 = any_number(0.0, 200.0);
    options.decomposition = static_cast<Decomposition>(*rc::gen::inRange(0, 3));
    const double ground_m2 = area_m2(PolygonSet{{ground}});
    options.small = SmallParts::kMerge;
    const RegionParts kept = region_parts({{ground}}, options);
    options.merge = true;
    const RegionParts merged = region_parts({{ground}}, options);
    RC_ASSERT(merged.parts.size() <= kept.parts.size());
    RC_ASSERT(line_sum(merged, options.width_m) <= line_sum(kept, options.width_m));
    options.small = SmallParts::kDrop;
    const RegionParts dropped = region_parts({{ground}}, options);
    for (const RegionParts* parts : {&kept, &merged, &dropped}) {
      RC_ASSERT(std::abs(area_m2(*parts) + dropped_m2(*parts) - ground_m2) < kSum_m2);
      for (const RegionPart& part : parts->parts) {
        RC_ASSERT(is_swept_whole(part.outline_W, part.sweep_rad));
      }
    }
    for (const Ring& small : dropped.dropped_W) {
      RC_ASSERT(signed_area_m2(small) < options.least_m2);
    }
  }));
}

TEST(MadeUpRegion, HasExactlyAsManyPartsAsAsked) {
  for (const int parts : {1, 2, 5, 6, 7, 8, 12, 40, 200}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const Field field = made_up_region({parts, -1, 3e5, seed}, "test");
      EXPECT_NEAR(field_area_m2(field), 3e5, 1e-3);
      Field checked = field;
      check_field(checked, "test");
      EXPECT_EQ(checked.boundary, field.boundary);
      const RegionParts made = region_parts(from_field(field), {});
      EXPECT_EQ(static_cast<int>(made.parts.size()), parts);
      if (parts > kPartsWithoutHoles) continue;
      EXPECT_TRUE(field.holes.empty());
      for (const RegionPart& part : made.parts) {
        EXPECT_GE(signed_area_m2(part.outline_W), kLeastShare * 3e5 / parts - kSum_m2);
      }
    }
  }
}

TEST(MadeUpRegion, DependsOnItsSeedAlone) {
  const auto boundary = [](std::uint64_t seed) {
    return made_up_region({6, -1, 3e5, seed}, "test").boundary;
  };
  EXPECT_EQ(boundary(3), boundary(3));
  EXPECT_NE(boundary(3), boundary(4));
}

TEST(MadeUpRegion, RefusesWhatThereIsNot) {
  EXPECT_THAT(refusal([] {
                made_up_region({0, -1, 3e5, 1}, "spec.yaml");
              }),
              HasSubstr("spec.yaml: parts: '0': a whole number from 1 to 1000"));
  EXPECT_THAT(refusal([] {
                made_up_region({5, 3, 3e5, 1}, "spec.yaml");
              }),
              HasSubstr("holes: '3': at most 2 for 5 parts"));
  EXPECT_THAT(refusal([] {
                made_up_region({5, -1, -1.0, 1}, "spec.yaml");
              }),
              HasSubstr("area_m2: '-1': an area above 0 m2"));
}

}  // namespace
}  // namespace headland
