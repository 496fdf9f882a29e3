// A square field with a hole, in UTM and in degrees, as tests of boundaries read it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "refusal.h"
#include "terrains/field_source.h"
#include "terrains/geo_frame.h"

namespace headland::test {

// Coordinates in degrees are written with 7 digits by some drivers: 1e-7 deg is 11 mm, and each
// side of the field has two ends.
inline constexpr double kDegreeDigits_m = 0.02;

inline Ring square(double left, double bottom, double side) {
  return {
      {left, bottom}, {left + side, bottom}, {left + side, bottom + side}, {left, bottom + side}};
}

// How the source is refused.
inline std::string line_of(const FieldSource& source) {
  return refusal([&] { read_field(source, "demo.yaml"); });
}

// The same 200 m square with a 50 m hole on zone 15's central meridian, in UTM and in degrees.
inline const std::vector<Ring> kUtmRings = {square(500000.0, 4860000.0, 200.0),
                                            square(500050.0, 4860050.0, 50.0)};

inline std::vector<Ring> rings_in_degrees() {
  std::vector<Ring> rings;
  for (const Ring& ring : kUtmRings) rings.push_back(wgs84_from_crs("EPSG:32615", ring, "test"));
  return rings;
}

// UTM's scale is 0.9996 on its central meridian.
inline constexpr double kUtmScale = 0.9996;
inline constexpr double kTrueSide_m = 200.0 / kUtmScale;
inline constexpr double kTrueHole_m = 50.0 / kUtmScale;

inline void expect_the_square(const Field& field) {
  ASSERT_TRUE(field.frame.georeferenced);
  ASSERT_EQ(field.boundary.size(), 4U);
  ASSERT_EQ(field.holes.size(), 1U);
  EXPECT_NEAR(signed_area_m2(field.boundary), kTrueSide_m * kTrueSide_m,
              4.0 * kTrueSide_m * kDegreeDigits_m);
  EXPECT_NEAR(signed_area_m2(field.holes[0]), -kTrueHole_m * kTrueHole_m,
              4.0 * kTrueHole_m * kDegreeDigits_m);
  // The origin is the middle, rounded to 1e-4 deg: at most 8 m away.
  Eigen::Vector2d mean_W = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p_W : field.boundary) mean_W += 0.25 * p_W;
  EXPECT_LT(mean_W.norm(), 8.0);
}

}  // namespace headland::test
