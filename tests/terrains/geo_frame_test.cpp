#include "terrains/geo_frame.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "random_ring.h"
#include "refusal.h"

namespace headland {
namespace {

using testing::HasSubstr;

// PROJ's transverse Mercator series is good to nanometres; a micrometre leaves room for degrees
// held as doubles (1e-14 of 180 is a nanometre on the ground).
constexpr double kRoundTrip_m = 1e-6;

GeoFrame frame_at(double longitude_deg, double latitude_deg) {
  return {.georeferenced = true, .latitude_deg = latitude_deg, .longitude_deg = longitude_deg};
}

TEST(GeoFrame, LocalToWgs84AndBackIsTheSamePoint) {
  EXPECT_TRUE(rc::check([] {
    const GeoFrame frame = frame_at(any_number(-179.0, 179.0), any_number(-75.0, 75.0));
    std::vector<Eigen::Vector2d> p_W;
    for (int i = 0; i < 5; ++i) {
      p_W.emplace_back(any_number(-5000.0, 5000.0), any_number(-5000.0, 5000.0));
    }
    const auto back_W = local_from_wgs84(frame, wgs84_from_local(frame, p_W));
    for (std::size_t i = 0; i < p_W.size(); ++i) {
      RC_ASSERT((back_W[i] - p_W[i]).norm() < kRoundTrip_m);
    }
  }));
}

TEST(GeoFrame, OriginIsWhereItIsSaidToBe) {
  const auto p_W = local_from_wgs84(frame_at(-93.976, 43.924), {{-93.976, 43.924}});
  EXPECT_LT(p_W[0].norm(), kRoundTrip_m);
}

TEST(GeoFrame, MetresAreMetresOfTheWgs84Ellipsoid) {
  // Radii of curvature of the ellipsoid; over 1e-3 deg the arc differs from the chord and the
  // radius from its mean by less than a millimetre.
  constexpr double kArc_m = 1e-3;
  const double a_m = 6378137.0;
  const double e2 = 0.00669437999014;
  const double latitude_deg = 43.924;
  const double sine = std::sin(latitude_deg * std::numbers::pi / 180.0);
  const double cosine = std::cos(latitude_deg * std::numbers::pi / 180.0);
  const double east_radius_m = a_m / std::sqrt(1.0 - e2 * sine * sine);
  const double north_radius_m = east_radius_m * (1.0 - e2) / (1.0 - e2 * sine * sine);
  const double step_rad = 1e-3 * std::numbers::pi / 180.0;
  const auto p_W =
      local_from_wgs84(frame_at(-93.976, latitude_deg),
                       {{-93.976 + 1e-3, latitude_deg}, {-93.976, latitude_deg + 1e-3}});
  EXPECT_NEAR(p_W[0].x(), east_radius_m * cosine * step_rad, kArc_m);
  EXPECT_NEAR(p_W[1].y(), north_radius_m * step_rad, kArc_m);
  EXPECT_NEAR(p_W[1].x(), 0.0, kRoundTrip_m);
}

TEST(Wgs84FromCrs, UtmCentralMeridianIsAtHalfAMillion) {
  // Easting 500 000 and northing 0 are on zone 15's central meridian and the equator by definition.
  const auto lon_lat_deg = wgs84_from_crs("EPSG:32615", {{500000.0, 0.0}}, "test");
  EXPECT_NEAR(lon_lat_deg[0].x(), -93.0, 1e-11);
  EXPECT_NEAR(lon_lat_deg[0].y(), 0.0, 1e-11);
}

TEST(Wgs84FromCrs, LongitudeComesFirstWhateverTheAuthoritySays) {
  const auto lon_lat_deg = wgs84_from_crs("EPSG:4326", {{-93.9, 43.9}, {10.0, -20.0}}, "test");
  EXPECT_EQ(lon_lat_deg[0], Eigen::Vector2d(-93.9, 43.9));
  EXPECT_EQ(lon_lat_deg[1], Eigen::Vector2d(10.0, -20.0));
}

TEST(Wgs84FromCrs, UnknownCrsIsRefused) {
  EXPECT_EQ(refusal([] {
              wgs84_from_crs("EPSG:99999999", {{0.0, 0.0}}, "field.yaml");
            }),
            "field.yaml: crs: 'EPSG:99999999': unknown CRS; give an authority code such as "
            "EPSG:32615, WKT or PROJ");
}

TEST(Wgs84FromCrs, CrsIsNeverReadFromAFileOrTheNetwork) {
  EXPECT_THAT(refusal([] {
                wgs84_from_crs("/etc/hostname", {{0.0, 0.0}}, "a");
              }),
              HasSubstr("unknown CRS"));
}

TEST(Wgs84FromCrs, MetresTakenForDegreesAreRefused) {
  EXPECT_THAT(refusal([] {
                wgs84_from_crs("EPSG:4326", {{9.0, 44.0}, {420000.0, 4.8e6}}, "a");
              }),
              HasSubstr("a: point 2: '420000, 4800000': not degrees"));
}

TEST(Wgs84FromCrs, LatitudeFirstIsRefusedWhereItCannotBe) {
  EXPECT_THAT(refusal([] {
                wgs84_from_crs("EPSG:4326", {{43.9, -93.9}}, "a");
              }),
              HasSubstr("longitude -180..180 first"));
}

TEST(Wgs84FromCrs, PointOutsideTheDomainIsRefused) {
  EXPECT_THAT(refusal([] {
                wgs84_from_crs("EPSG:32615", {{1e12, 1e12}}, "a");
              }),
              HasSubstr("outside the domain of the CRS"));
}

TEST(PlaceText, SaysDegreesOrMetres) {
  EXPECT_EQ(place_text({}, {1.0, -2.5}), "x 1.000 m, y -2.500 m");
  EXPECT_EQ(place_text(frame_at(9.5, 44.25), {0.0, 0.0}), "lon 9.5000000, lat 44.2500000");
}

}  // namespace
}  // namespace headland
