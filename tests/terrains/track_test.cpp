#include "terrains/track.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "refusal.h"
#include "scratch_folder.h"
#include "vector_writer.h"

namespace headland {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Field field_in(const GeoFrame& frame) {
  Field field;
  field.name = "home";
  field.boundary = {{-500.0, -500.0}, {500.0, -500.0}, {500.0, 500.0}, {-500.0, 500.0}};
  field.frame = frame;
  return field;
}
const GeoFrame kFrameOnEarth{.georeferenced = true, .latitude_deg = 44.0, .longitude_deg = -93.0};
const Field kLocal = field_in({});
const Field kOnEarth = field_in(kFrameOnEarth);

class TrackFile : public ScratchFolder {
 protected:
  Track csv(std::string_view content, const Field& field = kLocal) const {
    return read_track(written("track.csv", content), field);
  }
  std::string refused(std::string_view content, const Field& field = kLocal) const {
    const std::string line = refusal([&] { csv(content, field); });
    const std::string file = path("track.csv").string();
    EXPECT_TRUE(line == "accepted" || line.starts_with(file)) << line;
    return line.starts_with(file) ? line.substr(file.size()) : line;
  }
};

const std::vector<Eigen::Vector2d> kThreePoints = {{0.0, 0.0}, {5.5, 0.0}, {5.5, -3.25}};

TEST_F(TrackFile, CsvIsReadInAllItsDialects) {
  for (std::string_view content :
       {"x,y\n0,0\n5.5,0\n5.5,-3.25\n",                       //
        "\xEF\xBB\xBFx,y\r\n0,0\r\n5.5,0\r\n5.5,-3.25\r\n",   // byte order mark, CRLF
        "X_M;Y_M\n0;0\n5,5;0\n5,5;-3,25",                     // decimal commas, no last newline
        "y\tname\tx\n0\ta\t0\n0\tb\t+5.5\n-3.25\tc\t5.50\n",  // tabs, other order
        "# from a tool\n\n\"easting\",\"northing\"\n\"0\", 0\n5.5 , 0\n\n5.5e0,-325e-2\n",
        "x,y,note\n0,0,\"a, \"\"b\"\"\"\n5.5,0,\n5.5,-3.25,c\n"}) {
    const Track track = csv(content);
    EXPECT_EQ(track.points_W, kThreePoints) << content;
    EXPECT_THAT(track.break_before, IsEmpty());
  }
}

TEST_F(TrackFile, LongitudeAndLatitudeComeToTheLocalFrame) {
  const Track track = csv("Latitude,Longitude\n44,-93\n44.001,-93\n", kOnEarth);
  ASSERT_EQ(track.points_W.size(), 2U);
  EXPECT_LT(track.points_W[0].norm(), 1e-6);
  // A thousandth of a degree of latitude is 111.1 m there.
  EXPECT_NEAR(track.points_W[1].y(), 111.1, 0.05);
}

TEST_F(TrackFile, FrameDecidesWhenBothAreThere) {
  const std::string_view both = "x,y,lon,lat\n1,2,-93,44\n9,2,-93.0001,44\n";
  EXPECT_EQ(csv(both).points_W[0], Eigen::Vector2d(1.0, 2.0));
  EXPECT_LT(csv(both, kOnEarth).points_W[0].norm(), 1e-6);
}

// The usual interval is 2 s and the usual step 1 m: 6 s are no pause, 7 s are.
TEST_F(TrackFile, PausesInLineAreNoBreaks) {
  const Track track =
      csv("t_s,x,y\n0,0,0\n2,1,0\n4,2,0\n10,3,0\n12,4,0\n19,5,0\n21,6,0\n23,7,0\n1,8,0\n3,9,0\n");
  EXPECT_EQ(track.points_W.size(), 10U);
  EXPECT_THAT(track.break_before, IsEmpty());
  EXPECT_EQ(track.pauses.count, 2) << "19 s and the step back to 1 s";
  EXPECT_EQ(track.pauses.breaks, 0);
  EXPECT_EQ(track.pauses.longest_interval_s, 6.0);
  EXPECT_EQ(track.pauses.longest_step_m, 3.0);
}

TEST_F(TrackFile, PausesAreBreaksWhereThePlaceJumpsOrTheHeadingTurns) {
  // 10, 40, 70 s: on in line by 2.9 m; by 3.1 m; with a turn of 45 degrees after it.
  const Track track =
      csv("t,x,y\n0,0,0\n2,1,0\n4,2,0\n14,4.9,0\n16,5.9,0\n46,9,0\n48,10,0\n50,11,0\n"
          "80,12,0\n82,13,1\n84,14,2\n86,14.6,2.6\n");
  EXPECT_THAT(track.break_before, ElementsAre(5U, 8U));
  EXPECT_EQ(track.pauses.count, 3);
  EXPECT_EQ(track.pauses.breaks, 2);
  // Negative control: the same turn without a pause.
  EXPECT_THAT(csv("t,x,y\n0,10,0\n2,11,0\n4,12,0\n6,13,1\n8,14,2\n").break_before, IsEmpty());
}

TEST_F(TrackFile, AReceiverWanderingInAPauseTurnsNothing) {
  // 0.4 m sideways and back is not a heading; the work goes on as before.
  const Track track = csv("t,x,y\n0,0,0\n1,2,0\n2,4,0\n60,4,0.4\n61,6,0\n62,8,0\n");
  EXPECT_THAT(track.break_before, IsEmpty());
  EXPECT_EQ(track.pauses.count, 1);
}

TEST_F(TrackFile, TimeMayBeADate) {
  // Over midnight and from one time zone to another: 2, 2, 2 and 30 s.
  const Track track =
      csv("timestamp,x,y\n2011-11-05T23:59:57Z,0,0\n2011-11-05T23:59:59Z,1,0\n"
          "2011-11-06T00:00:01.000Z,2,0\n2011-11-06T02:00:03+02:00,3,0\n"
          "2011-11-06 00:00:33Z,40,0\n2011-11-06T00:00:35Z,41,0\n");
  EXPECT_EQ(track.points_W.size(), 6U);
  EXPECT_THAT(track.break_before, ElementsAre(4U));
  EXPECT_EQ(refused("t,x,y\nnoon,0,0\n"), ": line 2, t: 'noon': a finite number");
}

TEST_F(TrackFile, ClockSetBackByLittleIsNoBreak) {
  EXPECT_THAT(csv("t,x,y\n0,0,0\n3,1,0\n6,2,0\n4,3,0\n7,4,0\n").break_before, IsEmpty());
}

TEST_F(TrackFile, RaisedImplementIsLeftOutAndBreaks) {
  const Track track = csv("x,y,working\n0,0,1\n1,0,1\n2,0,0\n3,0,0\n4,0,1\n5,0,1\n");
  EXPECT_EQ(track.points_W.size(), 4U);
  EXPECT_THAT(track.break_before, ElementsAre(2U));
  EXPECT_EQ(refused("x,y,working\n0,0,1\n1,0,2\n"),
            ": line 3, working: '2': 0 or up (raised), 1 or down (working)");
}

TEST_F(TrackFile, RepeatedPlacesAreMergedAndLonePointsLeftOut) {
  EXPECT_EQ(csv("x,y\n0,0\n0,0\n5.5,0\n5.5,0.0005\n5.5,-3.25\n").points_W, kThreePoints);
  const Track track = csv("t,x,y\n0,0,0\n1,1,0\n2,2,0\n50,9,9\n99,3,0\n100,4,0\n101,5,0\n");
  EXPECT_EQ(track.points_W.size(), 6U);
  EXPECT_THAT(track.break_before, ElementsAre(3U));
}

TEST_F(TrackFile, WaitingOnTheSpotIsNoBreak) {
  const Track track = csv("t,x,y\n0,0,0\n1,1,0\n60,1,0\n61,2,0\n62,3,0\n");
  EXPECT_EQ(track.points_W.size(), 4U);
  EXPECT_THAT(track.break_before, IsEmpty());
}

TEST_F(TrackFile, BadCsvIsRefusedWithItsLine) {
  EXPECT_EQ(refused("x,y\n0,0\n1,two\n"), ": line 3, y: 'two': a finite number");
  EXPECT_EQ(refused("x,y\n0,0\nnan,2\n"), ": line 3, x: 'nan': a finite number");
  EXPECT_EQ(refused("x,y\n0,0\n1e999,2\n"), ": line 3, x: '1e999': a finite number");
  EXPECT_EQ(refused("x,y\n0,0\n,2\n"), ": line 3, x: a finite number");
  EXPECT_EQ(refused("x,y\n0,0\n\n1\n"), ": line 4: '1 cells': 2 cells, as in the header on line 1");
  EXPECT_EQ(refused("x,y\n0,0\n\"1,2\n"), ": line 3: a quote is never closed");
  EXPECT_EQ(refused(""), ": is empty");
  EXPECT_EQ(refused("a,b\n0,0\n"),
            ": line 1: 'a, b': the header must name x and y (metres) or lon and lat (degrees)");
}

TEST_F(TrackFile, TooFewPointsAreRefused) {
  EXPECT_EQ(refused("x,y\n1,1\n"),
            ": '1 points': a track has at least two different points that follow each other");
  EXPECT_THAT(refused("x,y,x\n1,1,9\n5,5,9\n"), HasSubstr("line 1, x: the column stands twice"));
  EXPECT_THAT(refused("x,y\n1,1\n1,1\n"), HasSubstr("'2 points': a track has at least two"));
}

TEST_F(TrackFile, JumpOfKilometresIsRefusedNamingBothLines) {
  EXPECT_EQ(refused("x,y\n-1050,0\n-1049,0\n1051,0\n"),
            ": lines 3 and 4: '2100 m apart': neighbours at most 2000 m apart; take out the stray "
            "point");
}

TEST_F(TrackFile, PointsFarFromTheFieldAreRefusedSayingWhatTheirCoordinatesAre) {
  // 1000 m beyond the field is near, as the terrain may reach so far.
  EXPECT_EQ(refused("x,y\n1490,0\n1500,0\n"), "accepted");
  EXPECT_EQ(refused("x,y\n1490,0\n1501,0\n"),
            ": line 3: '1501, 0': lies 1.0 km from the field 'home': take out the stray point");
  EXPECT_EQ(refused("x,y\n500000,4872000\n500010,4872000\n"),
            ": line 2: '500000, 4872000': lies 4897 km from the field 'home': x,y are metres of "
            "the coordinates that the field is given in");
  EXPECT_EQ(refused("easting,northing\n500000,4872000\n500010,4872000\n", kOnEarth),
            ": line 2: '500000, 4872000': lies 4897 km from the field 'home': x,y are local metres "
            "east and north of the field's middle (longitude -93.0000, latitude 44.0000); use "
            "lon,lat");
  EXPECT_THAT(refused("lon,lat\n-92,44\n-92.001,44\n", kOnEarth),
              HasSubstr("line 2: '-92, 44': lies 80 km from the field 'home': is it another "
                        "field's, or are longitude and latitude swapped?"));
}

TEST_F(TrackFile, DegreesNamedXAndYAreTold) {
  EXPECT_EQ(refused("x,y\n-93,44\n-93.001,44\n", kOnEarth),
            ": line 2: '-93, 44': looks like degrees; x,y are metres, name the columns lon,lat");
  // Negative control: a short track in metres.
  EXPECT_EQ(refused("x,y\n-93,44\n-92.4,44\n", kOnEarth), "accepted");
}

TEST_F(TrackFile, DegreesWithoutAPlaceOnTheEarthAreRefused) {
  EXPECT_THAT(refused("lon,lat\n-93,44\n-93.001,44\n"),
              HasSubstr("longitude and latitude need a field with a place on the earth"));
  EXPECT_THAT(refused("x,y\n-93,44\n-93.001,44\n"),
              HasSubstr("line 2: '-93, 44': looks like degrees"));
}

TEST_F(TrackFile, MetresInTheColumnsOfDegreesAreRefused) {
  EXPECT_THAT(refused("lon,lat\n0,0\n500,44\n", kOnEarth),
              HasSubstr("point 2: '500, 44': not degrees"));
}

OGRLineString line_of(const std::vector<Eigen::Vector2d>& points) {
  OGRLineString line;
  for (const Eigen::Vector2d& point : points) line.addPoint(point.x(), point.y());
  return line;
}

TEST_F(TrackFile, LinesOfAVectorFileAreJoinedWhereTheyMeet) {
  const OGRLineString first = line_of({{0.0, 0.0}, {10.0, 0.0}});
  const OGRLineString meets = line_of({{10.0, 0.0}, {10.0, 10.0}});
  const OGRLineString apart = line_of({{20.0, 10.0}, {20.0, 0.0}});
  write_features(path("a.geojson"), "GeoJSON", "", {&first, &meets, &apart});
  const Track track = read_track(path("a.geojson"), kLocal);
  EXPECT_EQ(track.points_W.size(), 5U);
  EXPECT_THAT(track.break_before, ElementsAre(3U));
}

TEST_F(TrackFile, LinesWithTheImplementUpAreLeftOut) {
  const auto lines = [](std::string_view down, std::string_view up) {
    const auto line = [](std::string_view state, double x) {
      return fmt::format(
          R"({{"type":"Feature","properties":{{"implement":{}}},"geometry":{{"type":"LineString",)"
          R"("coordinates":[[{},0],[{},0]]}}}})",
          state, x, x + 10);
    };
    return fmt::format(R"({{"type":"FeatureCollection","features":[{},{},{}]}})", line(down, 0),
                       line(up, 10), line(down, 20));
  };
  for (const auto& [down, up] :
       {std::pair{R"("down")", R"("up")"}, {"1", "0"}, {"true", "false"}}) {
    const Track track = read_track(written("a.geojson", lines(down, up)), kLocal);
    EXPECT_EQ(track.points_W.size(), 4U) << down;
    EXPECT_THAT(track.break_before, ElementsAre(2U)) << down;
  }
  EXPECT_THAT(refusal([&] { read_track(written("b.geojson", lines("0", "0")), kLocal); }),
              HasSubstr("b.geojson: no point with the implement down: 'implement' never is"));
  EXPECT_THAT(refusal([&] { read_track(written("c.geojson", lines("1", "7")), kLocal); }),
              HasSubstr("c.geojson: feature 2, implement: '7': 0 or up (raised), 1 or down"));
}

TEST_F(TrackFile, EveryFormatOfGdalReadsBackTheSame) {
  OGRMultiLineString lines;
  const OGRLineString one = line_of({{-93.0, 44.0}, {-93.0, 44.001}});
  const OGRLineString other = line_of({{-93.001, 44.001}, {-93.001, 44.0}});
  lines.addGeometry(&one);
  lines.addGeometry(&other);
  const auto expected_W = local_from_wgs84(
      kFrameOnEarth, {{-93.0, 44.0}, {-93.0, 44.001}, {-93.001, 44.001}, {-93.001, 44.0}});
  for (const auto& [driver, name] :
       {std::pair{"GeoJSON", "a.geojson"}, {"GPKG", "a.gpkg"}, {"KML", "a.kml"}}) {
    write_features(path(name), driver, "EPSG:4326", {&lines});
    const Track track = read_track(path(name), kOnEarth);
    ASSERT_EQ(track.points_W.size(), 4U) << name;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT((track.points_W[i] - expected_W[i]).norm(), 1e-3) << name;
    }
    EXPECT_THAT(track.break_before, ElementsAre(2U));
  }
}

TEST_F(TrackFile, GpxIsReadOnce) {
  const auto file = written("a.gpx", R"(<?xml version="1.0"?>
<gpx version="1.1" creator="test" xmlns="http://www.topografix.com/GPX/1/1"><trk><trkseg>
<trkpt lat="44" lon="-93"/><trkpt lat="44.001" lon="-93"/></trkseg></trk></gpx>)");
  EXPECT_EQ(read_track(file, kOnEarth).points_W.size(), 2U);
}

TEST_F(TrackFile, BadVectorFilesAreRefused) {
  const auto line = [&](const std::filesystem::path& file, const Field& field) {
    return refusal([&] { read_track(file, field); });
  };
  EXPECT_EQ(line("/nowhere/a.csv", kLocal), "/nowhere/a.csv: no such file");
  EXPECT_EQ(line("/nowhere/a.geojson", kLocal), "/nowhere/a.geojson: no such file");
  EXPECT_THAT(line(written("a.geojson", "{\n\"type\": \"Line"), kLocal),
              HasSubstr("a.geojson: line 2: malformed JSON"));
  const OGRPoint point(1.0, 2.0);
  write_features(path("b.geojson"), "GeoJSON", "", {&point});
  EXPECT_THAT(line(path("b.geojson"), kLocal), HasSubstr("holds no line"));
  const OGRLineString degrees = line_of({{-93.0, 44.0}, {-93.0, 44.001}});
  write_features(path("c.gpkg"), "GPKG", "EPSG:4326", {&degrees});
  EXPECT_THAT(line(path("c.gpkg"), kLocal), HasSubstr("need a field with a place on the earth"));
  write_features(path("d.geojson"), "GeoJSON", "", {&degrees});
  EXPECT_THAT(line(path("d.geojson"), kLocal), HasSubstr("point 1: '-93, 44': looks like degrees"));
}

}  // namespace
}  // namespace headland
