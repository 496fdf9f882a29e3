#include "render/vehicle_sheet.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "render/palette.h"
#include "terrains/input_error.h"
#include "tests/render/made_run.h"

namespace headland {
namespace {

constexpr PictureSize kSmall{640, 400};

// Pixels of about that colour: thin lines are blended with what is behind them.
std::ptrdiff_t pixels_of(const Image& image, Rgba colour) {
  constexpr int kBlended = 25;
  const auto near = [](std::uint8_t a, std::uint8_t b) { return std::abs(a - b) < kBlended; };
  std::ptrdiff_t count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    count += near(image.rgba[i], colour.r) && near(image.rgba[i + 1], colour.g) &&
             near(image.rgba[i + 2], colour.b);
  }
  return count;
}

TEST(VehicleSheet, ShowsTheVehicleItsFiguresAndWhereItTips) {
  Vehicle vehicle = level_run(10.0, 10.0, 5.0).vehicle;
  vehicle.body.mass_kg = 1000.0;
  vehicle.body.com_B = {0.4 * wheelbase_m(vehicle), 0.0, 0.8};
  const SheetFigure mass{"Mass", "1 t"};
  const Image image = draw_vehicle_sheet(vehicle, {&mass, 1}, kSmall);
  EXPECT_EQ(image.width, kSmall.width);
  EXPECT_EQ(image.height, kSmall.height);
  // Four tipping points with their lines.
  EXPECT_GT(pixels_of(image, colours::kEnd), 40);
  // Same vehicle, same bytes; another text, another picture.
  EXPECT_EQ(draw_vehicle_sheet(vehicle, {&mass, 1}, kSmall).rgba, image.rgba);
  const SheetFigure other{"Mass", "2 t"};
  EXPECT_NE(draw_vehicle_sheet(vehicle, {&other, 1}, kSmall).rgba, image.rgba);
}

TEST(VehicleSheet, ShowsShapesInTheirColours) {
  Vehicle vehicle = level_run(10.0, 10.0, 5.0).vehicle;
  const Image plain = draw_vehicle_sheet(vehicle, {}, kSmall);
  Shape box;
  box.size = {vehicle.body.length_m, vehicle.body.width_m, 0.5};
  box.X.translation() = Eigen::Vector3d(0.5, 0.0, 1.0);
  box.rgb = {{0.0, 0.0, 1.0}};
  Shape mast;
  mast.kind = ShapeKind::kCylinder;
  mast.size = {0.05, 0.05, 1.0};
  mast.X.translation() = Eigen::Vector3d(0.5, 0.0, 1.7);
  Shape ball;
  ball.kind = ShapeKind::kSphere;
  ball.size.setConstant(0.2);
  ball.X.translation() = Eigen::Vector3d(0.5, 0.0, 2.3);
  vehicle.shapes = {box, mast, ball};
  const Image blue = draw_vehicle_sheet(vehicle, {}, kSmall);
  const auto blueish = [](const Image& image) {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      count += image.rgba[i + 2] > 90 && image.rgba[i] < 20 && image.rgba[i + 1] < 20;
    }
    return count;
  };
  EXPECT_EQ(blueish(plain), 0);
  EXPECT_GT(blueish(blue), 1000);
}

TEST(VehicleSheet, RefusesAPictureTooSmallToRead) {
  EXPECT_THROW(draw_vehicle_sheet(level_run(10.0, 10.0, 5.0).vehicle, {}, {100, 100}), InputError);
}

}  // namespace
}  // namespace headland
