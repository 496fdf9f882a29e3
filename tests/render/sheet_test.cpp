// Lines as triangles: they cover what is within half their width, and nothing else.
#include "render/sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace headland {
namespace {

using Point2 = Eigen::Vector2d;

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

bool covers(const Sheet& sheet, const Point2& p) {
  for (std::size_t i = 0; i + 2 < sheet.vertices.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      return Point2(sheet.vertices[i + k].p_px.head<2>().cast<double>());
    };
    const double ab = cross(at(1) - at(0), p - at(0));
    const double bc = cross(at(2) - at(1), p - at(1));
    const double ca = cross(at(0) - at(2), p - at(2));
    const bool left = ab >= 0.0 && bc >= 0.0 && ca >= 0.0;
    if (left || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0)) return true;
  }
  return false;
}

double distance_to(const std::vector<Point2>& line, const Point2& p, bool closed) {
  double least = (p - line.front()).norm();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    const Point2 a = line[i];
    const Point2 leg = line[(i + 1) % line.size()] - a;
    const double share =
        leg.norm() > 0.0 ? std::clamp((p - a).dot(leg) / leg.squaredNorm(), 0.0, 1.0) : 0.0;
    least = std::min(least, (p - a - share * leg).norm());
  }
  return least;
}

TEST(Stroke, CoversWhatIsWithinHalfItsWidth) {
  constexpr double kWidth_px = 9.0;
  // Round parts are polygons of 22 sides, whose middles lie 1 % within the circle; in single
  // precision corners are off by far less than a hundredth of a pixel.
  constexpr double kInner = 0.5 * kWidth_px * 0.985;
  constexpr double kOuter = 0.5 * kWidth_px + 0.01;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  for (const bool closed : {false, true}) {
    for (int trial = 0; trial < 10; ++trial) {
      std::vector<Point2> line;
      for (int i = 0; i < 6; ++i) line.emplace_back(place(random), place(random));
      line.insert(line.begin() + 2, line[2]);  // a repeated point has no direction
      Sheet sheet;
      stroke(sheet, line, kWidth_px, colours::kInk, closed);
      for (int i = 0; i < 400; ++i) {
        const Point2 p(place(random), place(random));
        const double away = distance_to(line, p, closed);
        if (away < kInner) {
          EXPECT_TRUE(covers(sheet, p)) << p.transpose();
        }
        if (away > kOuter) {
          EXPECT_FALSE(covers(sheet, p)) << p.transpose();
        }
      }
    }
  }
}

TEST(Stroke, OfOnePointIsADisc) {
  Sheet sheet;
  stroke(sheet, std::vector<Point2>{{5.0, 5.0}, {5.0, 5.0}}, 8.0, colours::kInk);
  EXPECT_TRUE(covers(sheet, {5.0, 8.8}));
  EXPECT_FALSE(covers(sheet, {5.0, 9.2}));
  Sheet nothing;
  stroke(nothing, std::vector<Point2>{}, 8.0, colours::kInk);
  EXPECT_TRUE(nothing.vertices.empty());
}

// A track of a whole day has a million points: straight ones must cost no more than the line.
TEST(Stroke, TakesNothingForPointsThatBendNothing) {
  std::vector<Point2> line;
  for (int i = 0; i <= 1000; ++i) line.emplace_back(0.1 * i, 0.05 * i);
  Sheet sheet;
  stroke(sheet, line, 4.0, colours::kInk);
  constexpr std::size_t kOfALeg = 6;
  EXPECT_LE(sheet.vertices.size(), 1000 * kOfALeg + 3 * 48);
}

TEST(Simplified, StaysWithinItsToleranceAndKeepsTheEnds) {
  constexpr double kTolerance_px = 0.1;
  std::vector<Eigen::Vector3d> circle;
  std::vector<Point2> kept_line;
  for (int i = 0; i <= 3000; ++i) {
    const double angle = 1.8 * std::numbers::pi * i / 3000;
    circle.emplace_back(50.0 * std::cos(angle), 50.0 * std::sin(angle), 0.0);
  }
  const auto kept = simplified(circle, kTolerance_px);
  EXPECT_EQ(kept.front(), circle.front());
  EXPECT_EQ(kept.back(), circle.back());
  // Chords that bulge by the tolerance span 2 acos(1 - 0.1 / 50), a 50th of the circle.
  EXPECT_GE(kept.size(), 45U);
  EXPECT_LE(kept.size(), 120U);
  for (const auto& p : kept) kept_line.emplace_back(p.head<2>());
  for (const auto& p : circle) {
    EXPECT_LE(distance_to(kept_line, p.head<2>(), false), kTolerance_px + 1e-9);
  }
}

}  // namespace
}  // namespace headland
