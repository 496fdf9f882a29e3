#include "evaluate/job_plan.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "evaluate/audit.h"
#include "evaluate/job_ground.h"
#include "evaluate/path_check.h"
#include "evaluate/scenario_keys.h"
#include "planner/worked_rows.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "tests/evaluate/results_folder.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::string rectangle(double left, double bottom, double right, double top) {
  return fmt::format("[[{0}, {1}], [{2}, {1}], [{2}, {3}], [{0}, {3}]]", left, bottom, right, top);
}

std::string entry(const std::string& name, const std::string& boundary, const std::string& gates,
                  const std::string& more = "") {
  return fmt::format("  - {{name: {}, field: {{boundary: {}{}}}, gates: [{}]}}\n", name, boundary,
                     more, gates);
}

// Three fields beside a lane along y = -10, the middle one between the two others.
const std::string kWest = entry("west", rectangle(0, 0, 36, 26), "[18, 0]");
const std::string kMiddle = entry("middle", rectangle(60, 0, 96, 26), "[62, 0], [94, 0]");
const std::string kEast = entry("east", rectangle(120, 0, 156, 26), "[138, 0]");
const std::string kLane = "roads: [[[-20, -10], [180, -10]]]\n";
const std::string kVehicle = "vehicle: transplanter\n";

std::string job(const std::string& fields, const std::string& more = "") {
  return "fields:\n" + fields + kVehicle + more;
}

class Jobs : public test::ResultsFolder {
 protected:
  JobSpec spec(const std::string& text) const { return read_job(write("job.yaml", text)); }
  JobPlan planned(const std::string& text) const { return plan_job(spec(text)); }
  std::string refused(const std::string& text) const {
    return refusal([&] { planned(text); });
  }
  std::string infeasible(const std::string& text) const {
    try {
      planned(text);
    } catch (const PlanInfeasible& error) {
      return error.what();
    }
    return "planned";
  }
};

Audit audit_of(const JobPlan& plan) {
  return audit_path(plan.stage.field, plan.stage.vehicle, lines_of(plan.path), 0.25);
}

std::vector<std::string> names_of(const JobPlan& plan) {
  std::vector<std::string> names;
  for (const JobPart& part : plan.parts) {
    names.push_back(part.transit ? part.from + ">" + part.to : part.name);
  }
  return names;
}

double length_of(const JobPlan& plan, bool transits) {
  double sum_m = 0.0;
  for (const JobPart& part : plan.parts) sum_m += part.transit == transits ? part.length_m : 0.0;
  return sum_m;
}

TEST_F(Jobs, OnePathThroughAllFieldsKeepsToFieldsAndRoads) {
  const JobPlan plan =
      planned(job(kWest + kEast + kMiddle, kLane + "start: [-20, -10]\nend: [180, -10]\n"));
  // From one end of the lane to the other the fields come in the order they lie in.
  EXPECT_EQ(names_of(plan), (std::vector<std::string>{"start>west", "west", "west>middle", "middle",
                                                      "middle>east", "east", "east>end"}));
  // Once along the lane, and in and out of every field: the middle one in and out by its gates on
  // either side.
  EXPECT_NEAR(plan.road_length_m, 200.0 - (94.0 - 62.0) + 6 * 10.0, 1e-6);
  check_path(plan.path, plan.stage.field, "path");
  const Audit audit = audit_of(plan);
  EXPECT_TRUE(passes(audit));
  // Only the fields are to be worked; the corners of a field as small as this stay unworked.
  EXPECT_NEAR(audit.coverage.workable_m2, 3 * 36.0 * 26.0, 1e-6);
  EXPECT_GT(audit.coverage.covered_m2, 0.9 * audit.coverage.workable_m2);
  EXPECT_LT(audit.coverage.outside_m2, 0.01 * audit.coverage.workable_m2);
  std::size_t segments = 0;
  double expected_s = 0.0;
  for (const JobPart& part : plan.parts) {
    EXPECT_EQ(part.first_segment, segments);
    segments += part.segments;
    expected_s += part.expected_time_s;
    EXPECT_EQ(part.transit, part.passes == 0);
    for (std::size_t i = 0; i < part.segments; ++i) {
      const PathSegment& segment = plan.path.segments[part.first_segment + i];
      EXPECT_FALSE(part.transit && segment.implement_down);
    }
  }
  EXPECT_EQ(segments, plan.path.segments.size());
  EXPECT_GT(expected_s, 0.0);
  EXPECT_NEAR(length_of(plan, true) + length_of(plan, false), length_m(plan.path), 1e-6);
}

// As large as the fields, without the roads: a path that leaves the corridors is told.
TEST_F(Jobs, WithoutTheRoadsTheTransitsAreOutside) {
  JobPlan plan = planned(job(kWest + kMiddle, kLane));
  ASSERT_TRUE(passes(audit_of(plan)));
  plan.stage.field.boundary = {{0, 0}, {36, 0}, {36, 26}, {0, 26}};
  plan.stage.field.to_work.clear();
  EXPECT_FALSE(passes(audit_of(plan)));
}

TEST_F(Jobs, TheOrderIsTheShortestOrTheOneGiven) {
  const std::string fields = kWest + kEast + kMiddle;
  const JobPlan best = planned(job(fields, kLane));
  const JobPlan given = planned(job(fields, kLane + "order: given\n"));
  EXPECT_EQ(names_of(given),
            (std::vector<std::string>{"west", "west>east", "east", "east>middle", "middle"}));
  EXPECT_EQ(names_of(best)[2], "middle");
  EXPECT_LT(best.road_length_m, given.road_length_m);
}

TEST_F(Jobs, StraightFromGateToGateWithoutRoads) {
  const std::string a = entry("a", rectangle(0, 0, 36, 26), "[36, 13]");
  const std::string b = entry("b", rectangle(60, 0, 96, 26), "[60, 13]");
  const JobPlan plan = planned(job(a + b));
  EXPECT_NEAR(plan.road_length_m, 24.0, 1e-9);
  EXPECT_TRUE(passes(audit_of(plan)));
  // Through a pond between them there is no straight way.
  const std::string around = entry("around", rectangle(0, -40, 100, -4), "[2, -4], [98, -22]",
                                   ", holes: [" + rectangle(40, -30, 60, -10) + "]");
  const std::string far = entry("far", rectangle(130, -40, 166, -4), "[130, -22]");
  EXPECT_EQ(infeasible(job(around + far)), "planned");
  const std::string behind = entry("behind", rectangle(-60, -40, -24, -4), "[-24, -22]");
  const std::string west = entry("around", rectangle(0, -40, 100, -4), "[98, -22]",
                                 ", holes: [" + rectangle(40, -30, 60, -10) + "]");
  EXPECT_THAT(infeasible(job(behind + west, "order: given\n")),
              HasSubstr("no sequence of the fields has a way from each to the next one"));
}

TEST_F(Jobs, PartsThatTouchNeedNoRoad) {
  const std::string south = entry("south", rectangle(0, 0, 40, 26), "[20, 26]");
  const std::string north = entry("north", rectangle(0, 26, 40, 52), "[20, 26]");
  const JobPlan plan = planned(job(south + north));
  EXPECT_EQ(plan.road_length_m, 0.0);
  EXPECT_EQ(plan.parts.size(), 3U);
  EXPECT_TRUE(passes(audit_of(plan)));
  EXPECT_EQ(plan.stage.field.boundary.size(), 4U);
}

// With the headland first the vehicle ends among the rows that it has worked.
TEST_F(Jobs, TransitsKeepOffRowsAndBendSteadilyWhereAsked) {
  const std::string fields = kWest + kEast;
  const std::string first =
      kLane + "planner: {headland_order: first, swath_direction_deg: 0}\nend: [-20, -10]\n";
  const auto over_m = [](const JobPlan& plan) {
    return driven_over_worked(plan.stage.field, plan.stage.vehicle, plan.path).length_m;
  };
  const JobPlan plain = planned(job(fields, first));
  EXPECT_GT(over_m(plain), 10.0);
  const JobPlan off = planned(job(fields, first + "path: {keep_off_worked: true}\n"));
  EXPECT_EQ(over_m(off), 0.0);
  EXPECT_TRUE(passes(audit_of(off)));
  EXPECT_EQ(job_json(off, {}, "1")["over_worked_rows_m"], 0.0);
  EXPECT_GT(job_json(plain, {}, "1")["over_worked_rows_m"], 10.0);
  const JobPlan steady = planned(job(fields, first + "path: {continuous_turns: true}\n"));
  EXPECT_GT(length_of(steady, true), length_of(plain, true)) << "ramps take room";
  EXPECT_TRUE(passes(audit_of(steady)));
  EXPECT_EQ(steady.path.abrupt_turns, 0);
}

// Of the road alone, one piece, which bends from its begin on: ramps find no straight before it.
TEST_F(Jobs, TellAJumpOnce) {
  std::string bend;
  for (int i = 0; i <= 20; ++i) {
    const double turned_rad = 0.05 * (i - 20);
    bend += fmt::format("{}[{:.6f}, {:.6f}]", bend.empty() ? "" : ", ",
                        30.0 * std::cos(turned_rad) - 12.0, 30.0 * std::sin(turned_rad));
  }
  const std::string start = bend.substr(0, bend.find(']') + 1);
  const std::string asked = "path: {continuous_turns: true}\nplanner: {swath_direction_deg: 0}\n";
  const JobPlan plan =
      planned(job(kWest, "roads: [[" + bend + "]]\nstart: " + start + "\n" + asked));
  const nlohmann::ordered_json json = job_json(plan, {}, "1");
  const nlohmann::ordered_json field = job_json(planned(job(kWest, asked)), {}, "1");
  EXPECT_EQ(field["abrupt_turns"], 0);
  EXPECT_EQ(json["abrupt_turns"], 1);
  EXPECT_GT(field["abrupt_joints"], 0) << "its headland pass ends in a bend";
  EXPECT_EQ(json["abrupt_joints"], field["abrupt_joints"]) << "the way in reaches a straight swath";
}

TEST_F(Jobs, EachFieldMayHaveItsPlanner) {
  const std::string turned = "  - {name: b, field: {boundary: " + rectangle(60, 0, 96, 26) +
                             "}, gates: [[60, 13]], planner: {swath_direction_deg: 90}}\n";
  const JobSpec read = spec(job(entry("a", rectangle(0, 0, 36, 26), "[36, 13]") + turned));
  EXPECT_EQ(std::get<double>(read.fields[1].planner.parameters.at("swath_direction_deg")), 90.0);
  EXPECT_NE(read.fields[0].planner.parameters, read.fields[1].planner.parameters);
}

// The same fields in longitude and latitude give the same work and the same ways.
TEST_F(Jobs, FieldsOnTheEarthShareAFrame) {
  const GeoFrame place{true, 52.0, 9.0};
  const auto degrees = [&](const Ring& ring) {
    std::string text = "[";
    for (const Eigen::Vector2d& p : wgs84_from_local(place, ring)) {
      text += fmt::format("{}[{:.10f}, {:.10f}]", text.size() > 1 ? ", " : "", p.x(), p.y());
    }
    return text + "]";
  };
  std::string fields;
  for (const double left : {0.0, 600.0}) {
    fields +=
        fmt::format("  - {{name: f{}, field: {{crs: 'EPSG:4326', boundary: {}}}, gates: {}}}\n",
                    left, degrees({{left, 0}, {left + 36, 0}, {left + 36, 26}, {left, 26}}),
                    degrees({{left + 18, 0}}));
  }
  const std::string lane = "roads: [" + degrees({{-20, -10}, {700, -10}}) + "]\n";
  const JobPlan plan = planned(job(fields, lane));
  ASSERT_TRUE(plan.stage.field.frame.georeferenced);
  EXPECT_NEAR(plan.road_length_m, 600.0 + 20.0, 1e-3);
  EXPECT_TRUE(passes(audit_of(plan)));
  const JobPlan local = planned(job(entry("f0", rectangle(0, 0, 36, 26), "[18, 0]") +
                                        entry("f1", rectangle(600, 0, 636, 26), "[618, 0]"),
                                    "roads: [[[-20, -10], [700, -10]]]\n"));
  EXPECT_EQ(plan.plan.passes.size(), local.plan.passes.size());
  EXPECT_NEAR(length_of(plan, true), length_of(local, true), 0.5);
  // What is written is what was planned: the same frame, ground and ground to work.
  const fs::path file = write("scenario.yaml", scenario_yaml(plan.scenario));
  const Field read = read_field(read_scenario(file).field, file.string());
  EXPECT_EQ(read.frame.latitude_deg, plan.stage.field.frame.latitude_deg);
  EXPECT_EQ(read.frame.longitude_deg, plan.stage.field.frame.longitude_deg);
  EXPECT_EQ(read.boundary, plan.stage.field.boundary);
  ASSERT_EQ(read.to_work.size(), 2U);
  EXPECT_EQ(read.to_work, plan.stage.field.to_work);
  EXPECT_NEAR(std::abs(signed_area_m2(read.to_work[1])), 36.0 * 26.0, 0.01);
}

TEST_F(Jobs, WhatADriveTookIsToldByPart) {
  const JobPlan plan = planned(job(kWest + kMiddle, kLane));
  RunRecord run;
  double time_s = 0.0;
  for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
    SegmentRecord segment;
    segment.segment = static_cast<int>(i);
    segment.duration_s = 1.0 + static_cast<double>(i);
    segment.distance_m = 2.0;
    segment.energy.battery_j = 3600.0;
    time_s += segment.duration_s;
    run.segments.push_back(segment);
  }
  const std::vector<JobPartRun> parts = runs_of_parts(plan, run);
  ASSERT_EQ(parts.size(), plan.parts.size());
  double sum_s = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    sum_s += parts[i].time_s;
    EXPECT_EQ(parts[i].battery_j, 3600.0 * static_cast<double>(plan.parts[i].segments));
  }
  EXPECT_NEAR(sum_s, time_s, 1e-9);
  const nlohmann::ordered_json json = job_json(plan, parts, "1");
  EXPECT_EQ(json["parts"][1]["driven"]["battery_wh"], static_cast<double>(plan.parts[1].segments));
  EXPECT_NEAR(json["totals"]["fields"]["driven"]["time_s"].get<double>() +
                  json["totals"]["transits"]["driven"]["time_s"].get<double>(),
              time_s, 1e-9);
}

TEST_F(Jobs, CancellingIsHeard) {
  const JobSpec read = spec(job(kWest + kMiddle, kLane));
  EXPECT_THROW(plan_job(read, [] { return true; }), Cancelled);
}

TEST_F(Jobs, BadJobsAreRefusedWithTheirPlace) {
  EXPECT_THAT(refused("vehicle: transplanter\n"), HasSubstr("fields: '0': from 1 to 60 fields"));
  EXPECT_THAT(refused("fields:\n" + kWest), HasSubstr("vehicle: the key is missing"));
  EXPECT_THAT(refused(job(kWest, "raods: []\n")), HasSubstr("did you mean 'roads'?"));
  EXPECT_THAT(refused(job("  - {field: {boundary: " + rectangle(0, 0, 36, 26) + "}}\n")),
              HasSubstr("line 2: gates: '0 gates': from 1 to 20 points"));
  EXPECT_THAT(refused(job("  - {gates: [[0, 0]]}\n")), HasSubstr("field: the section is missing"));
  EXPECT_THAT(refused(job(entry("a", rectangle(0, 0, 36, 26), "[18, 0]", ", entry: [1, 1]"))),
              HasSubstr("line 2: field.entry: the gates say where it is entered"));
  EXPECT_THAT(refused(job(kWest + kWest)), HasSubstr("two fields have this name"));
  EXPECT_THAT(refused(job(kWest, "planner: {name: grid_tplp}\n")),
              HasSubstr("planner: 'grid_tplp': jobs are planned on fields, not on grid maps"));
  EXPECT_THAT(
      refused(job(kWest, "order: best\n")),
      HasSubstr("order: 'best': unknown word; did you mean 'shortest'? (known: shortest, given)"));
  EXPECT_THAT(refused(job(kWest, "road_width_m: 0\n")), HasSubstr("road_width_m: '0'"));
  EXPECT_THAT(refused(job(kWest, "roads: [[[0, 0]]]\n")),
              HasSubstr("a road is a line of at least two points"));
  EXPECT_THAT(refused(job(kWest, "crs: EPSG:32632\n")),
              HasSubstr("crs: 'EPSG:32632': the fields have no place on the earth"));
  EXPECT_THAT(refused(job(entry("a", rectangle(0, 0, 36, 26), "[18, 11]"))),
              HasSubstr("gates: 'x 18.000 m, y 11.000 m': lies 11.0 m from the boundary of 'a'"));
  EXPECT_THAT(refused(job(kWest + entry("b", rectangle(30, 0, 80, 26), "[60, 0]"))),
              HasSubstr("'b': shares 156 m2 with 'west'; fields of a job do not overlap"));
  EXPECT_THAT(refused(job(kWest, kLane + "start: [0, -60]\n")),
              HasSubstr("start: 'x 0.000 m, y -60.000 m': no road comes nearer than 30 m"));
  EXPECT_THAT(
      refused(job(kWest +
                  "  - {name: b, field: {crs: 'EPSG:4326', boundary: [[9, 52], [9.001, 52], "
                  "[9.001, 52.001]]}, gates: [[9, 52]]}\n")),
      HasSubstr("one of 'west' and 'b' has a place on the earth and the other has none"));
  std::string many;
  for (int i = 0; i < 13; ++i) {
    many += entry(fmt::format("f{}", i), rectangle(50.0 * i, 0, 50.0 * i + 36, 26),
                  fmt::format("[{}, 0]", 50.0 * i));
  }
  EXPECT_THAT(refused(job(many)), HasSubstr("order: '13 fields': the best order is found for at "
                                            "most 12; give order: given"));
  EXPECT_THAT(infeasible(job(kWest + kMiddle,
                             "roads: [[[-20, -10], [30, -10]], [[60, -10], [90, -10]]]\n")),
              HasSubstr("no sequence of the fields has a way from each to the next one"));
  EXPECT_THAT(infeasible(job(kWest + kMiddle, kLane + "road_width_m: 1\n")),
              HasSubstr("transit from "));
  EXPECT_THAT(infeasible(job(entry("a", rectangle(0, 0, 7, 7), "[0, 0]"))),
              HasSubstr("field 'a': "));
}

TEST(Job, EveryKeyStandsInTheDocumentation) {
  std::ifstream stream(std::string(HEADLAND_SOURCE_DIR) + "/docs/jobs.md");
  std::stringstream page;
  page << stream.rdbuf();
  for (const std::string& path : job_key_paths()) {
    EXPECT_THAT(page.str(), HasSubstr("`" + path + "`"));
  }
}

}  // namespace
}  // namespace headland
