#include "evaluate/path_export.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numeric>

#include "evaluate/audit.h"
#include "evaluate/path_csv.h"
#include "evaluate/plan_file.h"
#include "planner/drivable_path.h"
#include "planner/planners.h"
#include "planner/segment.h"
#include "planner/work_line.h"
#include "terrains/field_source.h"
#include "terrains/task_data.h"
#include "tests/evaluate/results_folder.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

// Degrees with 10 decimals and metres with 6, in both axes.
constexpr double kWritten_m = 2e-5;
constexpr double kAngle = 1e-9;
// KML and GPX are written by GDAL, with 10 decimals of a degree or more.
constexpr double kLayer_m = 1e-4;

Field made_field() {
  Field field;
  field.name = "field <1> & \"2\"";
  field.boundary = {{-40, -30}, {50, -30}, {50, 30}, {-40, 30}};
  field.holes = {{{-10, -5}, {-10, 5}, {5, 5}, {5, -5}}};
  field.obstacles = {{ObstacleKind::kTree, {25, 10}, 0.3, 5.0}};
  field.entry_W = Eigen::Vector2d(-38, -28);
  field.frame = test::kOnEarth;
  return field;
}

struct Made {
  Field field = made_field();
  Vehicle vehicle = load_vehicle("transplanter");
  Plan plan;
  Path path;
};

const Made& made() {
  static const Made the = [] {
    Made one;
    PlanRequest request;
    request.field = one.field;
    request.working_width_m = one.vehicle.implement.working_width_m;
    request.turning_radius_m = planning_turning_radius_m(one.vehicle);
    request.vehicle_width_m = one.vehicle.body.width_m;
    request.vehicle_front_m = one.vehicle.body.length_m - one.vehicle.body.rear_overhang_m;
    request.vehicle_rear_m =
        std::max(one.vehicle.body.rear_overhang_m, -one.vehicle.implement.x_B_m);
    const PlannerEntry& planner = find_planner("boustrophedon", "test");
    request.parameters = resolve_parameters(planner.parameters, {}, "test", "planner");
    one.plan = planner.plan(request);
    one.path = make_path(one.field, one.vehicle, one.plan, {});
    return one;
  }();
  return the;
}

std::string written_as(ExportFormat format) {
  return export_text({made().path, made().field, made().vehicle, "1.0"}, format);
}

class PathExports : public test::ResultsFolder {
 protected:
  fs::path exported(ExportFormat format) const {
    const std::string ending(format == ExportFormat::kIsoxml ? "xml" : export_format_name(format));
    return write("path." + ending, written_as(format));
  }
};

void expect_the_path(const Path& read) {
  ASSERT_EQ(read.segments.size(), made().path.segments.size());
  for (std::size_t i = 0; i < read.segments.size(); ++i) {
    const PathSegment& a = made().path.segments[i];
    const PathSegment& b = read.segments[i];
    EXPECT_EQ(b.kind, a.kind);
    EXPECT_EQ(b.gear, a.gear);
    EXPECT_EQ(b.implement_down, a.implement_down);
    EXPECT_EQ(b.manoeuvre, a.manoeuvre);
    ASSERT_EQ(b.points.size(), a.points.size());
    for (std::size_t k = 0; k < a.points.size(); ++k) {
      EXPECT_LT((b.points[k].p_W - a.points[k].p_W).norm(), kWritten_m);
      EXPECT_NEAR(b.points[k].heading_rad, a.points[k].heading_rad, kAngle);
      EXPECT_NEAR(b.points[k].curvature_per_m, a.points[k].curvature_per_m, kAngle);
    }
  }
}

TEST_F(PathExports, GeoJsonAndCsvAreDrivenAsTheyAre) {
  for (const ExportFormat format : {ExportFormat::kGeoJson, ExportFormat::kCsv}) {
    const fs::path file = exported(format);
    ASSERT_TRUE(is_path_file(file));
    expect_the_path(read_path(file, made().field));
  }
  // Without a place on the earth likewise, in metres.
  Field nowhere = made().field;
  nowhere.frame = {};
  const fs::path file = write(
      "local.csv", export_text({made().path, nowhere, made().vehicle, "1"}, ExportFormat::kCsv));
  expect_the_path(read_path(file, nowhere));
  EXPECT_THAT(refusal([&] { read_path(file, made().field); }),
              HasSubstr("line 1, longitude_deg: the column is missing"));
}

// The field's frame is of no account: places on the earth are.
TEST_F(PathExports, CsvIsReadIntoAnyFrame) {
  Field moved = made().field;
  moved.frame.longitude_deg += 0.001;
  const Path read = read_path(exported(ExportFormat::kCsv), moved);
  const Eigen::Vector2d shift =
      made().path.segments[0].points[0].p_W - read.segments[0].points[0].p_W;
  EXPECT_NEAR(shift.x(), 0.001 * 111320.0 * std::cos(43.9241 * 3.14159265 / 180.0), 0.5);
}

TEST_F(PathExports, CsvTellsTheSpeedThatTheDriverAimsAt) {
  const std::string text = written_as(ExportFormat::kCsv);
  const Driver& driver = made().vehicle.driver;
  EXPECT_TRUE(text.starts_with(
      "x_m,y_m,heading_rad,curvature_per_m,gear,speed_mps,implement,kind,segment,manoeuvre,"
      "reference,longitude_deg,latitude_deg\n"));
  std::size_t rows = 0;
  double fastest_mps = 0.0;
  double last_mps = -1.0;
  for (std::size_t at = text.find('\n') + 1; at < text.size();
       at = text.find('\n', at) + 1, ++rows) {
    std::size_t cell = at;
    for (int comma = 0; comma < 5; ++comma) cell = text.find(',', cell) + 1;
    last_mps = std::stod(text.substr(cell));
    ASSERT_GE(last_mps, 0.0);
    fastest_mps = std::max(fastest_mps, last_mps);
  }
  std::size_t points = 0;
  for (const PathSegment& segment : made().path.segments) points += segment.points.size();
  EXPECT_EQ(rows, points);
  EXPECT_EQ(last_mps, 0.0);
  EXPECT_NEAR(fastest_mps, std::max(driver.work_speed_mps, driver.transit_speed_mps), 1e-3);
}

TEST_F(PathExports, DamagedCsvIsRefusedWithItsLine) {
  const std::string header =
      "x_m,y_m,heading_rad,curvature_per_m,gear,implement,kind,segment,manoeuvre\n";
  Field nowhere = made().field;
  nowhere.frame = {};
  const auto refused = [&](const std::string& rows) {
    const fs::path file = write("a.csv", header + rows);
    return refusal([&] { read_path(file, nowhere); });
  };
  EXPECT_EQ(refused("0,0,0,0,forward,down,swath,0,0\n1,0,0,0,forward,down,swath,0,0\n"),
            "accepted");
  EXPECT_THAT(refused("0,0,0,0,sideways,down,swath,0,0\n"),
              HasSubstr("line 2, gear: 'sideways': known: forward, reverse"));
  EXPECT_THAT(refused("0,0,0,0,forward,down,swath,1,0\n"),
              HasSubstr("line 2, segment: '1': -1 or 0: segments count up"));
  EXPECT_THAT(refused("0,0,0,0,forward,down,swath,0,0\n1,0,0,0,forward,up,swath,0,0\n"),
              HasSubstr("line 3, implement: 'up': up or down for a whole segment"));
  EXPECT_THAT(refused("0,0,nan,0,forward,down,swath,0,0\n"), HasSubstr("line 2, heading_rad"));
  EXPECT_THAT(refused("0,0,0,0,forward,down,swath,0,-1\n"), HasSubstr("a count from 0"));
  EXPECT_THAT(refused("0,0,3,0,forward,down,swath,0,0\n1,0,3,0,forward,down,swath,0,0\n"),
              HasSubstr("segment 0, point 2: 'heading_rad 3'"));
  EXPECT_THAT(refused(""), HasSubstr("holds no path segment"));
}

// Distance of `p` from the nearest of some lines.
double distance_m(const Eigen::Vector2d& p,
                  const std::vector<std::vector<Eigen::Vector2d>>& lines) {
  double nearest_m = 1e9;
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      nearest_m = std::min(nearest_m, distance_to_segment(p, line[i - 1], line[i]));
    }
  }
  return nearest_m;
}

TEST_F(PathExports, KmlAndGpxGiveTheSameAuditAsThePath) {
  const auto audit_of = [&](const fs::path& file) {
    return audit_path(made().field, made().vehicle, read_path_lines(file, made().field), 0.25);
  };
  const Audit own = audit_of(exported(ExportFormat::kGeoJson));
  EXPECT_TRUE(passes(own));
  for (const ExportFormat format : {ExportFormat::kKml, ExportFormat::kGpx, ExportFormat::kCsv}) {
    const Audit read = audit_of(exported(format));
    EXPECT_TRUE(passes(read)) << export_format_name(format);
    EXPECT_NEAR(read.length_m, own.length_m, 1e-3 * own.length_m);
    EXPECT_EQ(read.gear_changes, own.gear_changes);
    EXPECT_NEAR(read.working_length_m, own.working_length_m, 1e-2);
    EXPECT_NEAR(read.coverage.covered_m2, own.coverage.covered_m2, 1.0);
  }
}

// What GDAL makes of the files, without any reader of ours.
TEST_F(PathExports, GdalReadsKmlAndGpxWithPlacesAndProperties) {
  GDALAllRegister();
  for (const ExportFormat format :
       {ExportFormat::kGeoJson, ExportFormat::kKml, ExportFormat::kGpx}) {
    const std::string name(export_format_name(format));
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(exported(format).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
    ASSERT_NE(dataset, nullptr) << name;
    OGRLayer* layer = dataset->GetLayerByName(format == ExportFormat::kGpx ? "tracks" : "path");
    ASSERT_NE(layer, nullptr) << name;
    const std::string prefix = format == ExportFormat::kGpx ? "headland_" : "";
    std::size_t next = 0;
    for (const auto& feature : *layer) {
      ASSERT_LT(next, made().path.segments.size());
      const PathSegment& segment = made().path.segments[next++];
      const auto text = [&](const std::string& key) {
        return std::string(feature->GetFieldAsString((prefix + key).c_str()));
      };
      EXPECT_EQ(text("kind"), path_kind_name(segment.kind)) << name;
      EXPECT_EQ(text("gear"), gear_name(segment.gear)) << name;
      EXPECT_EQ(text("implement"), segment.implement_down ? "down" : "up") << name;
      const OGRGeometry* geometry = feature->GetGeometryRef();
      const OGRLineString* line = wkbFlatten(geometry->getGeometryType()) == wkbLineString
                                      ? geometry->toLineString()
                                      : geometry->toMultiLineString()->getGeometryRef(0);
      std::vector<Eigen::Vector2d> places;
      for (const OGRPoint& point : *line) places.emplace_back(point.getX(), point.getY());
      ASSERT_EQ(places.size(), segment.points.size()) << name;
      places = local_from_wgs84(made().field.frame, places);
      for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_LT((places[i] - segment.points[i].p_W).norm(), kLayer_m) << name;
      }
    }
    EXPECT_EQ(next, made().path.segments.size()) << name;
  }
}

TEST_F(PathExports, AKmlIsAlsoTheField) {
  FieldSource source;
  source.file = exported(ExportFormat::kKml);
  const Field read = read_field(source, "test");
  EXPECT_EQ(read.name, made().field.name);
  EXPECT_NEAR(field_area_m2(read), field_area_m2(made().field), 0.01);
  ASSERT_EQ(read.holes.size(), 1U);
  EXPECT_NEAR(signed_area_m2(read.holes[0]), -150.0, 0.01);
}

TEST_F(PathExports, TaskDataIsTheField) {
  FieldSource source;
  source.file = exported(ExportFormat::kIsoxml);
  const Field read = read_field(source, "test");
  EXPECT_EQ(read.name, made().field.name);
  ASSERT_EQ(read.boundary.size(), 4U);
  const auto here = [&](const Eigen::Vector2d& p_W) {
    return local_from_wgs84(made().field.frame, wgs84_from_local(read.frame, {p_W})).front();
  };
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT((here(read.boundary[i]) - made().field.boundary[i]).norm(), kWritten_m);
    EXPECT_LT((here(read.holes.at(0)[i]) - made().field.holes[0][i]).norm(), kWritten_m);
  }
  ASSERT_EQ(read.obstacles.size(), 1U);
  EXPECT_LT((here(read.obstacles[0].p_W) - made().field.obstacles[0].p_W).norm(), kWritten_m);
}

// Every pass is one guidance line, in the plan's order, where the implement's middle goes.
TEST_F(PathExports, TaskDataGuidesTheImplementAlongThePasses) {
  const fs::path file = exported(ExportFormat::kIsoxml);
  const Partfield partfield = read_task_data(file).partfields.at(0);
  std::vector<const GuidancePattern*> laid_out;
  int references = 0;
  for (const GuidancePattern& pattern : partfield.guidance) {
    EXPECT_EQ(pattern.line.width_m, made().vehicle.implement.working_width_m);
    if (!pattern.repeats) laid_out.push_back(&pattern);
    references += pattern.repeats ? 1 : 0;
  }
  EXPECT_EQ(references, 1);  // all swaths are parallel
  ASSERT_EQ(laid_out.size(), made().plan.passes.size());
  for (std::size_t i = 0; i < laid_out.size(); ++i) {
    const Pass& pass = made().plan.passes[i];
    const bool swath = pass.kind == PassKind::kSwath;
    EXPECT_EQ(laid_out[i]->kind, swath ? GuidanceKind::kAb : GuidanceKind::kCurve);
    const auto line = local_from_wgs84(made().field.frame, laid_out[i]->line.lon_lat_deg);
    // Swaths are shortened for turns and stay where they are. In bends of radius R an implement x
    // behind the axle swings out by x^2 / 2R, smoothing (work_line.h) draws in, and curves are
    // simplified.
    const double radius_m = min_turning_radius_m(made().vehicle);
    const double x_m = made().vehicle.implement.x_B_m;
    const double bend_m = (0.5 * x_m * x_m + kSmoothing_m * kSmoothing_m / 12.0) / radius_m;
    const double off_m = swath ? 1e-3 : bend_m + kGuidanceRounding_m;
    for (const Eigen::Vector2d& p_W : line) EXPECT_LT(distance_m(p_W, {pass.points_W}), off_m);
    if (!swath) continue;
    EXPECT_GT((line.back() - line.front()).dot(pass.points_W.back() - pass.points_W.front()), 0.0);
  }
  // The reference is one of the swaths.
  const auto reference =
      local_from_wgs84(made().field.frame, partfield.guidance[0].line.lon_lat_deg);
  ASSERT_EQ(reference.size(), 2U);
  EXPECT_TRUE(std::ranges::any_of(made().plan.passes, [&](const Pass& pass) {
    return distance_m(reference[0], {pass.points_W}) < 1e-3 &&
           distance_m(reference[1], {pass.points_W}) < 1e-3;
  }));
}

// Read as tracks, all formats cover what the plan covers: lines of the vehicle and lines of the
// implement alike.
TEST_F(PathExports, TracksReadBackWorkTheSameGround) {
  const auto covered_m2 = [&](const Path& path) {
    return audit_path(made().field, made().vehicle, lines_of(path), 0.25).coverage.covered_m2;
  };
  const double own_m2 = covered_m2(made().path);
  for (const ExportFormat format :
       {ExportFormat::kKml, ExportFormat::kGpx, ExportFormat::kIsoxml}) {
    const Track track = read_track(exported(format), made().field);
    EXPECT_EQ(track.of_vehicle, format != ExportFormat::kIsoxml);
    TrackReport report;
    PathOptions options;
    options.allow_overrun = true;  // smoothing may take a ring a little outwards
    const Path path = make_drivable(made().field, made().vehicle, track, 0.05, options, &report);
    // Smoothing within 5 cm on both sides of some 2 km of passes 2 m apart.
    EXPECT_NEAR(covered_m2(path), own_m2, 0.01 * own_m2) << export_format_name(format);
  }
}

TEST(PathExport, NeedsAPlaceOnTheEarth) {
  Field nowhere = made().field;
  nowhere.frame = {};
  const PathExport local{made().path, nowhere, made().vehicle, "1"};
  for (const ExportFormat format : kEveryExportFormat) {
    const std::string said = refusal([&] { export_text(local, format); });
    if (needs_place_on_earth(format)) {
      EXPECT_THAT(said, HasSubstr("give the place of its x 0, y 0 with --origin LON,LAT"));
    } else {
      EXPECT_EQ(said, "accepted");
    }
  }
}

TEST(PathExport, SameBytesEachTime) {
  for (const ExportFormat format : kEveryExportFormat) {
    EXPECT_EQ(written_as(format), written_as(format)) << export_format_name(format);
  }
}

}  // namespace
}  // namespace headland
