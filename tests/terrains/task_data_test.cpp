#include "terrains/task_data.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <cmath>

#include "random_ring.h"
#include "refusal.h"
#include "scratch_folder.h"
#include "terrains/field_source.h"
#include "terrains/track.h"

namespace headland {
namespace {

using testing::HasSubstr;

// Degrees are written with 10 decimals: half a unit of the last is 6 um on the ground.
constexpr double kWritten_deg = 0.5e-10 * 1.001;
// Areas of some 100 m across, from such degrees.
constexpr double kArea_m2 = 0.01;

constexpr GeoFrame kPlace{true, 52.0, 9.0};

class TaskDataFiles : public ScratchFolder {
 protected:
  std::filesystem::path task(const std::string& inside) const {
    return written("TASKDATA.XML",
                   "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                   "<ISO11783_TaskData VersionMajor=\"4\" VersionMinor=\"3\" "
                   "DataTransferOrigin=\"1\">\n" +
                       inside + "\n</ISO11783_TaskData>\n");
  }

  Field field(const std::filesystem::path& file, const std::string& part = "") const {
    FieldSource source;
    source.file = file;
    source.part = part;
    return read_field(source, "demo.yaml");
  }

  std::string refused(const std::string& inside, const std::string& part = "") const {
    return refusal([&] { field(task(inside), part); });
  }
};

std::string point(const Eigen::Vector2d& p_W) {
  const Eigen::Vector2d lon_lat = wgs84_from_local(kPlace, {p_W}).front();
  return fmt::format("<PNT A=\"2\" C=\"{:.10f}\" D=\"{:.10f}\"/>", lon_lat.y(), lon_lat.x());
}

// As version 4 closes rings, and as versions before left them open.
std::string line(int type, Ring ring, bool closed = true) {
  if (closed) ring.push_back(ring.front());
  std::string text = fmt::format("<LSG A=\"{}\">", type);
  for (const Eigen::Vector2d& p_W : ring) text += point(p_W);
  return text + "</LSG>";
}

std::string polygon(int type, const std::string& lines) {
  return fmt::format("<PLN A=\"{}\">{}</PLN>", type, lines);
}

std::string partfield(const std::string& id, const std::string& name, const std::string& inside) {
  return fmt::format("<PFD A=\"{}\" B=\"code {}\" C=\"{}\" D=\"100\">{}</PFD>", id, id, name,
                     inside);
}

// Wider than high, so that swapped axes show.
const Ring kGround = {{0, 0}, {200, 0}, {200, 100}, {0, 100}};
const Ring kPond = {{20, 20}, {50, 20}, {50, 60}, {20, 60}};
const Ring kHut = {{120, 40}, {130, 40}, {130, 45}, {120, 45}};

Ring moved(Ring ring, const Eigen::Vector2d& by) {
  for (Eigen::Vector2d& p : ring) p += by;
  return ring;
}

TEST_F(TaskDataFiles, AxesAndInnerRingsAreTheRightOnes) {
  for (const bool closed : {true, false}) {
    const Field read = field(task(partfield(
        "PFD1", "A",
        polygon(1, line(1, kGround, closed) + line(2, kPond, closed) + line(2, kHut, closed)))));
    ASSERT_TRUE(read.frame.georeferenced);
    EXPECT_NEAR(read.frame.latitude_deg, 52.0, 0.01);
    EXPECT_NEAR(read.frame.longitude_deg, 9.0, 0.01);
    EXPECT_NEAR(signed_area_m2(read.boundary), 200.0 * 100.0, kArea_m2);
    ASSERT_EQ(read.holes.size(), 2U);
    EXPECT_NEAR(signed_area_m2(read.holes[0]), -30.0 * 40.0, kArea_m2);
    EXPECT_NEAR(field_area_m2(read), 20000.0 - 1200.0 - 50.0, kArea_m2);
    // Where they lie, in the frame in which they were drawn.
    const auto at = [&](double x, double y) {
      return local_from_wgs84(read.frame, wgs84_from_local(kPlace, {{x, y}})).front();
    };
    EXPECT_TRUE(inside_field(read, at(190, 10)));
    EXPECT_FALSE(inside_field(read, at(35, 40)));
    EXPECT_FALSE(inside_field(read, at(125, 42)));
    EXPECT_FALSE(inside_field(read, at(10, 190)));
    EXPECT_NEAR(field_clearance_m(read, at(190, 10)), 10.0, 1e-3);
  }
}

TEST_F(TaskDataFiles, RingsInsideOthersAreHolesWhateverTheyAreMarkedAs) {
  const Field read =
      field(task(partfield("PFD1", "A", polygon(1, line(1, kPond) + line(1, kGround)))));
  EXPECT_NEAR(field_area_m2(read), 20000.0 - 1200.0, kArea_m2);
  ASSERT_EQ(read.holes.size(), 1U);
}

// Before version 4 one polygon may have several outlines, each with holes of its own.
TEST_F(TaskDataFiles, HolesGoWithTheOutlineAroundThem) {
  const Eigen::Vector2d away(300, 50);
  const auto file = task(partfield("PFD1", "A",
                                   polygon(1, line(1, kGround) + line(2, moved(kPond, away)) +
                                                  line(1, moved(kGround, away)) + line(2, kHut))));
  EXPECT_NEAR(field_area_m2(field(file, "1")), 20000.0 - 50.0, kArea_m2);
  EXPECT_NEAR(field_area_m2(field(file, "2")), 20000.0 - 1200.0, kArea_m2);
  EXPECT_THAT(refusal([&] { field(file); }),
              HasSubstr("'2 polygons': a field is one polygon with holes; choose one with "
                        "field.part, its name or number: 1 A, 1.99 ha; 2 A, 1.88 ha"));
  EXPECT_THAT(refusal([&] { field(file, "A"); }),
              HasSubstr("part: 'A': 2 polygons have this name; give the number of one"));
}

TEST_F(TaskDataFiles, PartfieldsAreChosenByNameCodeIdOrNumber) {
  const auto file =
      task(partfield("PFD1", "North", polygon(1, line(1, kGround))) +
           partfield("PFD7", "South &lt;1&gt;", polygon(1, line(1, moved(kPond, {0, -500})))) +
           partfield("PFD8", "no boundary", polygon(2, line(1, kHut))));
  for (const char* name : {"South <1>", "PFD7", "code PFD7", "2"}) {
    const Field read = field(file, name);
    EXPECT_EQ(read.name, "South <1>") << name;
    EXPECT_NEAR(field_area_m2(read), 1200.0, kArea_m2) << name;
  }
  EXPECT_NEAR(field_area_m2(field(file, "North")), 20000.0, kArea_m2);
  EXPECT_THAT(refusal([&] { field(file, "Nord"); }),
              HasSubstr("part: 'Nord': no polygon has this name; did you mean 'North'?"));
  EXPECT_THAT(refusal([&] { field(file, "3"); }), HasSubstr("no polygon has this name"));
}

TEST_F(TaskDataFiles, WaterBuildingsAndObstaclesAreNoGround) {
  const std::string tree = fmt::format("<PNT A=\"5\" B=\"tree\" {}", point({80, 50}).substr(11));
  const std::string beyond = fmt::format("<PNT A=\"5\" {}", point({800, 50}).substr(11));
  const std::string flag = fmt::format("<PNT A=\"1\" {}", point({90, 50}).substr(11));
  std::string fence = line(7, {{150, 10}, {150, 90}}, false);
  fence.replace(fence.find("A=\"7\""), 5, "A=\"7\" C=\"400\"");
  const Field read = field(task(partfield(
      "PFD1", "A",
      // The pond twice, as interior ring and as water; a treatment zone is not in the way.
      polygon(1, line(1, kGround) + line(2, kPond)) + polygon(3, line(1, kPond)) +
          polygon(4, line(1, kHut)) + polygon(2, line(1, moved(kHut, {0, 30}))) +
          polygon(6, line(1, moved(kHut, {0, 300}))) + tree + beyond + flag + fence)));
  EXPECT_NEAR(field_area_m2(read), 20000.0 - 1200.0 - 50.0, kArea_m2);
  EXPECT_EQ(read.holes.size(), 2U);
  ASSERT_EQ(read.obstacles.size(), 2U);
  EXPECT_EQ(read.obstacles[0].kind, ObstacleKind::kTree);
  EXPECT_EQ(read.obstacles[1].kind, ObstacleKind::kFence);
  EXPECT_NEAR(read.obstacles[1].run_W.norm(), 80.0, 1e-3);
  EXPECT_NEAR(read.obstacles[1].radius_m, 0.2, 1e-9);
}

TEST_F(TaskDataFiles, PartfieldsInFilesOfTheirOwnAreFollowed) {
  written("PFD00001.XML", "<?xml version=\"1.0\"?><XFC>" +
                              partfield("PFD1", "A", polygon(1, line(1, kGround))) + "</XFC>");
  EXPECT_NEAR(field_area_m2(field(task("<XFR A=\"PFD00001\" B=\"1\"/>"))), 20000.0, kArea_m2);
  EXPECT_THAT(refused("\n<XFR A=\"PFD../../x\" B=\"1\"/>"),
              HasSubstr("line 4, XFR A: 'PFD../../x': three letters and five digits"));
  EXPECT_THAT(refused("<XFR A=\"PFD00009\" B=\"1\"/>"), HasSubstr("PFD00009.XML: no such file"));
}

TEST_F(TaskDataFiles, TheFolderWillDo) {
  std::filesystem::create_directories(path("card"));
  written("card/taskdata.xml", "<ISO11783_TaskData>" +
                                   partfield("PFD1", "A", polygon(1, line(1, kGround))) +
                                   "</ISO11783_TaskData>");
  EXPECT_NEAR(field_area_m2(field(path("card"))), 20000.0, kArea_m2);
}

TEST_F(TaskDataFiles, WhatIsWrongIsToldWithItsLine) {
  EXPECT_THAT(refused("<PFD>"), HasSubstr("TASKDATA.XML: line 4: malformed XML: "));
  EXPECT_THAT(refused("<PFD A=\"PFD1\" C=\"A\" D=\"x\"/>"),
              HasSubstr("line 3, PFD D: 'x': area in m2: a number from 0 to"));
  const std::string before = "<PFD A=\"PFD1\" C=\"A\" D=\"1\"><PLN A=\"1\"><LSG A=\"1\">\n";
  const std::string after = "</LSG></PLN></PFD>";
  EXPECT_THAT(refused(before + "<PNT A=\"2\" C=\"91\" D=\"9\"/>" + after),
              HasSubstr("line 4, PNT C: '91': latitude in degrees: a number from -90 to 90"));
  EXPECT_THAT(refused(before + "<PNT A=\"2\" C=\"52\" D=\"181\"/>" + after),
              HasSubstr("line 4, PNT D: '181': longitude in degrees: a number from -180 to 180"));
  EXPECT_THAT(refused(before + "<PNT A=\"2\" C=\"52\"/>" + after), HasSubstr("PNT D: longitude"));
  EXPECT_THAT(refused(before + "<PNT A=\"2\" C=\"nan\" D=\"9\"/>" + after), HasSubstr("'nan'"));
  EXPECT_THAT(refused(before + "<PNT A=\"2\" C=\"1e999\" D=\"9\"/>" + after), HasSubstr("'1e999'"));
  EXPECT_THAT(refused(before + "<PNT A=\"0\" C=\"52\" D=\"9\"/>" + after),
              HasSubstr("PNT A: '0': type of the point: a number from 1 to 11"));
  EXPECT_THAT(refused(before + "<PNT A=\"2\" C=\"\" D=\"\" J=\"PNT00001\"/>" + after),
              HasSubstr("points in a binary file are not read"));
  EXPECT_THAT(refused(before + after), HasSubstr("a line without points (PNT)"));
  EXPECT_THAT(refused(before + point({0, 0}) + point({9, 9}) + after),
              HasSubstr("boundary: '2 points': bounds no area"));
  EXPECT_THAT(refused(partfield("PFD1", "A", polygon(1, line(3, kGround)))),
              HasSubstr("a polygon consists of lines of type 1 (exterior) and 2 (interior)"));
  EXPECT_THAT(refused(partfield("PFD1", "A", polygon(2, line(1, kGround)))),
              HasSubstr("no partfield (PFD) has a boundary"));
  EXPECT_THAT(refused(partfield("PFD1", "A",
                                polygon(1, line(1, kGround) + line(2, moved(kPond, {500, 0}))))),
              HasSubstr("hole 1: lies outside the boundary"));
}

// Entities are left as they stand: nothing is read from elsewhere, nothing grows.
TEST_F(TaskDataFiles, EntitiesAreNotExpanded) {
  written("secret.txt", "secret");
  const auto file = written(
      "TASKDATA.XML",
      "<?xml version=\"1.0\"?>\n<!DOCTYPE x [<!ENTITY a SYSTEM \"" + path("secret.txt").string() +
          "\"><!ENTITY b \"&a;&a;\"><!ENTITY c \"&b;&b;\">]>\n<ISO11783_TaskData>" +
          partfield("PFD1", "&a;&c;", polygon(1, line(1, kGround))) + "</ISO11783_TaskData>");
  EXPECT_EQ(field(file).name, "&a;&c;");
}

TEST_F(TaskDataFiles, DeepNestingIsNoTrouble) {
  constexpr int kDeep = 200000;
  std::string deep;
  for (int i = 0; i < kDeep; ++i) deep += "<X>";
  for (int i = 0; i < kDeep; ++i) deep += "</X>";
  EXPECT_NEAR(
      field_area_m2(field(task(deep + partfield("PFD1", "A", polygon(1, line(1, kGround)))))),
      20000.0, kArea_m2);
}

// Cut short anywhere, or with a byte changed, a file is read or refused, and nothing else.
TEST_F(TaskDataFiles, DamagedFilesAreReadOrRefused) {
  const std::string whole = "<ISO11783_TaskData>" +
                            partfield("PFD1", "A", polygon(1, line(1, kGround) + line(2, kPond))) +
                            "</ISO11783_TaskData>";
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    const auto cut = written("TASKDATA.XML", whole.substr(0, length));
    EXPECT_NE(refusal([&] { field(cut); }), "accepted") << length;
  }
  EXPECT_TRUE(rc::check([&] {
    std::string changed = whole;
    const auto at = static_cast<std::size_t>(*rc::gen::inRange<int>(0, int(whole.size())));
    changed[at] = static_cast<char>(*rc::gen::inRange<int>(0, 256));
    static_cast<void>(refusal([&] { field(written("TASKDATA.XML", changed)); }));
  }));
}

bool same(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if ((a[i] - b[i]).cwiseAbs().maxCoeff() > kWritten_deg) return false;
  }
  return true;
}

TEST_F(TaskDataFiles, WhatIsWrittenIsReadBack) {
  EXPECT_TRUE(rc::check([&] {
    const auto ring = [&](const Eigen::Vector2d& middle) {
      return wgs84_from_local(kPlace, any_ring(middle));
    };
    TaskData data;
    const int fields = *rc::gen::inRange(1, 4);
    for (int i = 0; i < fields; ++i) {
      Partfield made;
      made.name = "field <&\"'> " + std::to_string(i);
      made.code = *rc::gen::arbitrary<bool>() ? "7" : "";
      made.area_m2 = *rc::gen::inRange(0, 100000);
      made.polygons.push_back({TaskPolygonType::kBoundary, "", {}});
      made.polygons.back().rings.push_back({TaskLineType::kExterior, "", 0.0, ring({0, 0})});
      made.polygons.back().rings.push_back({TaskLineType::kInterior, "", 0.0, ring({9, 9})});
      made.lines.push_back({TaskLineType::kFence, "f", 0.25, ring({100, 0})});
      made.points.push_back({TaskPointType::kObstacle, "tree", ring({50, 0}).front()});
      made.guidance.push_back({"one",
                               "a",
                               GuidanceKind::kCurve,
                               false,
                               {TaskLineType::kGuidance, "", 6.0, ring({0, 50})}});
      made.guidance.push_back({"two",
                               "b",
                               GuidanceKind::kAb,
                               true,
                               {TaskLineType::kGuidance, "", 3.0, {{9.0, 52.0}, {9.1, 52.0}}}});
      data.partfields.push_back(made);
    }
    const TaskData read = read_task_data(written("TASKDATA.XML", task_data_text(data, "1")));
    RC_ASSERT(read.partfields.size() == data.partfields.size());
    for (std::size_t i = 0; i < data.partfields.size(); ++i) {
      const Partfield& a = data.partfields[i];
      const Partfield& b = read.partfields[i];
      RC_ASSERT(b.id == "PFD" + std::to_string(i + 1));
      RC_ASSERT(b.name == a.name);
      RC_ASSERT(b.code == a.code);
      RC_ASSERT(b.area_m2 == a.area_m2);
      for (std::size_t k = 0; k < 2; ++k) {
        RC_ASSERT(b.polygons[0].rings[k].type == a.polygons[0].rings[k].type);
        RC_ASSERT(same(b.polygons[0].rings[k].lon_lat_deg, a.polygons[0].rings[k].lon_lat_deg));
        RC_ASSERT(b.guidance[k].group == a.guidance[k].group);
        RC_ASSERT(b.guidance[k].name == a.guidance[k].name);
        RC_ASSERT(b.guidance[k].kind == a.guidance[k].kind);
        RC_ASSERT(b.guidance[k].repeats == a.guidance[k].repeats);
        RC_ASSERT(b.guidance[k].line.width_m == a.guidance[k].line.width_m);
        RC_ASSERT(same(b.guidance[k].line.lon_lat_deg, a.guidance[k].line.lon_lat_deg));
      }
      RC_ASSERT(b.lines[0].width_m == a.lines[0].width_m);
      RC_ASSERT(same(b.lines[0].lon_lat_deg, a.lines[0].lon_lat_deg));
      RC_ASSERT(b.points[0].name == a.points[0].name);
      RC_ASSERT(same({b.points[0].lon_lat_deg}, {a.points[0].lon_lat_deg}));
    }
  }));
}

TEST_F(TaskDataFiles, LongNamesAreCutBetweenCharacters) {
  TaskData data;
  data.partfields.emplace_back().name = std::string(31, 'x') + "\xC3\xA4\xC3\xB6";
  EXPECT_EQ(read_task_data(written("TASKDATA.XML", task_data_text(data, "1"))).partfields[0].name,
            std::string(31, 'x') + "\xC3\xA4");
}

// A pattern's line of points of W.
std::string pattern(int kind, int propagation, const Ring& points_W) {
  return fmt::format("<GPN A=\"GPN1\" C=\"{}\" E=\"{}\">{}</GPN>", kind, propagation,
                     line(5, points_W, false));
}

TEST_F(TaskDataFiles, GuidanceLinesAreATrack) {
  const std::string ground = polygon(1, line(1, kGround));
  const auto file =
      task(partfield("PFD1", "A",
                     ground + "<GGP A=\"GGP1\">" + pattern(1, 1, {{0, 50}, {200, 50}}) + "</GGP>" +
                         "<GGP A=\"GGP2\">" + pattern(1, 4, {{10, 10}, {190, 10}}) +
                         pattern(3, 4, {{190, 20}, {100, 22}, {10, 20}}) + "</GGP>") +
           partfield("PFD2", "B",
                     polygon(1, line(1, moved(kGround, {500, 0}))) + "<GGP A=\"GGP3\">" +
                         pattern(1, 4, {{510, 10}, {690, 10}}) + "</GGP>"));
  const Field a = field(file, "A");
  const auto at = [&](double x, double y) {
    return local_from_wgs84(a.frame, wgs84_from_local(kPlace, {{x, y}})).front();
  };
  const Track track = read_track(file, a);
  // The passes laid out in this field, in their order; neither the line to repeat nor the other's.
  ASSERT_EQ(track.points_W.size(), 5U);
  EXPECT_EQ(track.break_before, std::vector<std::size_t>{2});
  EXPECT_FALSE(track.of_vehicle);
  EXPECT_NEAR((track.points_W[1] - at(190, 10)).norm(), 0.0, 1e-3);
  EXPECT_NEAR((track.points_W[3] - at(100, 22)).norm(), 0.0, 1e-3);
  EXPECT_EQ(read_track(file, field(file, "B")).points_W.size(), 2U);
  Field nowhere = a;
  nowhere.frame = {};
  EXPECT_THAT(refusal([&] { read_track(file, nowhere); }),
              HasSubstr("longitude and latitude need a field with a place on the earth"));
  // Alone, the line to repeat is one to drive.
  EXPECT_EQ(read_path_lines(task(partfield("PFD1", "A",
                                           ground + "<GGP A=\"GGP1\">" +
                                               pattern(1, 1, {{0, 50}, {200, 50}}) + "</GGP>")),
                            a)
                .size(),
            1U);
  // As versions before 4 have it: lines of the partfield itself.
  EXPECT_EQ(read_path_lines(
                task(partfield("PFD1", "A", ground + line(5, {{0, 50}, {200, 50}}, false))), a)
                .size(),
            1U);
  EXPECT_THAT(refusal([&] {
                read_track(task(partfield(
                               "PFD1", "A",
                               ground + "<GGP A=\"GGP1\">" + pattern(2, 1, {{0, 50}}) + "</GGP>")),
                           a);
              }),
              HasSubstr("none of 1 partfields has guidance lines"));
}

}  // namespace
}  // namespace headland
