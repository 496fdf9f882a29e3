#include "terrains/obstacle_features.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "terrains/field_source.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

class ObstacleFeatures : public ScratchFolder {
 protected:
  // A field of 0.002 by 0.001 degrees with further features.
  FieldSource with(const std::string& features) const {
    FieldSource source;
    source.file =
        written("field.geojson",
                R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {},
            "geometry": {"type": "Polygon", "coordinates": [[[-93.002, 43.0], [-93.0, 43.0],
            [-93.0, 43.001], [-93.002, 43.001], [-93.002, 43.0]]]}})" +
                    features + "]}");
    return source;
  }
  static std::string feature(const std::string& properties, const std::string& type,
                             const std::string& coordinates) {
    return fmt::format(
        R"(, {{"type": "Feature", "properties": {{{}}}, "geometry": {{"type": "{}", )"
        R"("coordinates": {}}}}})",
        properties, type, coordinates);
  }
  Field read(const std::string& features) const { return read_field(with(features), "test.yaml"); }
  std::string refused(const std::string& features) const {
    const std::string message = refusal([&] { read(features); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
  }
};

const std::string kLine = "[[-93.0015, 43.0005], [-93.001, 43.0005], [-93.001, 43.0007]]";

TEST_F(ObstacleFeatures, ArePointsAndLinesWithSizes) {
  const Field field =
      read(feature(R"("obstacle": "rock", "radius_m": 0.8, "height_m": 0.5)", "Point",
                   "[-93.0005, 43.0005]") +
           feature(R"("obstacle": "wall", "thickness_m": 0.4)", "LineString", kLine));
  ASSERT_EQ(field.obstacles.size(), 3U);
  const Obstacle& rock = field.obstacles[0];
  EXPECT_EQ(rock.kind, ObstacleKind::kRock);
  EXPECT_EQ(rock.radius_m, 0.8);
  EXPECT_EQ(rock.height_m, 0.5);
  EXPECT_TRUE(rock.run_W.isZero(0.0));
  const Obstacle& wall = field.obstacles[1];
  EXPECT_EQ(wall.kind, ObstacleKind::kWall);
  EXPECT_EQ(wall.radius_m, 0.2);
  EXPECT_EQ(wall.height_m, 1.5);
  // Half a thousandth of a degree of longitude at 43 deg, and a fifth of latitude.
  EXPECT_NEAR(wall.run_W.x(), 40.77, 0.05);
  EXPECT_NEAR(wall.run_W.y(), 0.0, 0.01);
  const Obstacle& corner = field.obstacles[2];
  EXPECT_NEAR((corner.p_W - (wall.p_W + wall.run_W)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(corner.run_W.y(), 22.22, 0.05);
}

TEST_F(ObstacleFeatures, OtherFeaturesAreLeftAlone) {
  EXPECT_TRUE(read(feature(R"("name": "gate")", "Point", "[-93.0005, 43.0005]") +
                   feature(R"("name": "drain")", "LineString", kLine))
                  .obstacles.empty());
}

TEST_F(ObstacleFeatures, AreRefusedByFeatureAndProperty) {
  const std::string at = path("field.geojson").string() + ": feature 2";
  EXPECT_THAT(refused(feature(R"("obstacle": "wal")", "LineString", kLine)),
              HasSubstr(at + ": obstacle: 'wal': unknown obstacle; did you mean 'wall'?"));
  EXPECT_EQ(refused(feature(R"("obstacle": "wall")", "Point", "[-93.001, 43.0005]")),
            at + ": 'wall': runs along a line of at least two different points");
  EXPECT_EQ(refused(feature(R"("obstacle": "tree")", "LineString", kLine)),
            at + ": 'tree': stands at a point; walls and fences run along lines");
  EXPECT_EQ(refused(feature(R"("obstacle": "tree")", "Point", "[]")),
            at + ": 'tree': has no geometry that says where it is");
  EXPECT_THAT(refused(feature(R"("obstacle": "rock")", "Polygon",
                              "[[[-93.001, 43.0005], [-93.0009, 43.0005], [-93.0009, 43.0006], "
                              "[-93.001, 43.0005]]]")),
              HasSubstr(at + ": 'POLYGON': an obstacle is a point or a line"));
  EXPECT_EQ(refused(feature(R"("obstacle": "wall", "thickness_m": -1)", "LineString", kLine)),
            at + ": thickness_m: '-1': a number from 0.02 to 10 m");
  EXPECT_EQ(
      refused(feature(R"("obstacle": "tree", "radius_m": "big")", "Point", "[-93.001, 43.0005]")),
      at + ": radius_m: 'big': a number from 0.01 to 50 m");
  EXPECT_THAT(refused(feature(R"("obstacle": "tree")", "Point", "[-93.003, 43.0005]")),
              HasSubstr(at + ": lies outside the boundary at lon -93.003"));
  EXPECT_THAT(refused(feature(R"("obstacle": "fence")", "LineString",
                              "[[-93.001, 43.0005], [-93.01, 43.0005]]")),
              HasSubstr("m outside the boundary (at most 100 m) at lon -93.01"));
}

TEST_F(ObstacleFeatures, WithoutAPlaceAreRefused) {
  const std::string at = path("field.geojson").string() + ": feature 2: ";
  const std::string tree = R"("obstacle": "tree")";
  EXPECT_EQ(refused(feature(tree, "Point", "[]")),
            at + "'tree': has no geometry that says where it is");
  EXPECT_EQ(
      refused(R"(, {"type": "Feature", "properties": {"obstacle": "tree"}, "geometry": null})"),
      at + "'tree': has no geometry that says where it is");
  EXPECT_EQ(refused(feature(R"("obstacle": "fence")", "MultiLineString",
                            "[[], [[-93.0015, 43.0005], [-93.001, 43.0005]]]")),
            at + "'LINESTRING': a part of its geometry is empty");
}

// A line surveyed every few centimetres keeps its bends and loses the points between them.
TEST_F(ObstacleFeatures, AFenceLosesItsSmallBends) {
  std::string line = "[";
  constexpr int kPoints = 1000;
  for (int i = 0; i <= kPoints; ++i) {
    line += fmt::format("{}[{:.9f}, {:.9f}]", i == 0 ? "" : ", ", -93.0018 + 1e-6 * i,
                        43.0005 + 5e-6 * std::sin(0.01 * i));
  }
  const Field field = read(feature(R"("obstacle": "fence")", "LineString", line + "]"));
  EXPECT_LT(field.obstacles.size(), 60U);
  EXPECT_GT(field.obstacles.size(), 5U);
  double length_m = 0.0;
  for (const Obstacle& piece : field.obstacles) length_m += piece.run_W.norm();
  // 1e-3 degrees of longitude at 43 deg; the waves add a little.
  EXPECT_NEAR(length_m, 81.5, 0.5);
}

TEST_F(ObstacleFeatures, AFenceMayRunAlongTheBoundary) {
  EXPECT_EQ(read(feature(R"("obstacle": "fence")", "LineString",
                         "[[-93.0021, 42.99999], [-92.9999, 42.99999]]"))
                .obstacles.size(),
            1U);
}

}  // namespace
}  // namespace headland
