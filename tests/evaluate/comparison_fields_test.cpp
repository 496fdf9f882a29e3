// Comparisons on fields: reading, gaps to the proven optimum, files.
#include "evaluate/comparison_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "evaluate/comparison_figures.h"
#include "evaluate/comparison_file.h"
#include "evaluate/comparison_reader.h"
#include "planner/region_generator.h"
#include "tests/evaluate/made_up_costs.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

constexpr double kLengthSum_m = 1e-6;  // rounding of sums of some kilometres

class FieldComparison : public ScratchFolder {
 protected:
  Comparison read(const std::string& text) const {
    return read_comparison(written("compare.yaml", text));
  }
  std::string refused(const std::string& text) const {
    return refusal([&] { read(text); });
  }
};

const std::string kFourParts = "parts: {width_m: 40}\nfields: [{generator: {parts: 4}}]\n";
const std::string kRegionPlanners =
    "planners:\n  - {name: region_iga, label: IGA, population: 20}\n"
    "  - {name: region_exact, label: exact}\n"
    "  - {name: region_local_search, label: ours, sweeps: any}\n";

// A U, 90 m by 60 m, with two arms of 30 m; a cut at each of its two concave corners.
const std::string kU =
    "{name: u, boundary: [[0, 0], [90, 0], [90, 60], [60, 60], [60, 20], [30, 20], [30, 60], [0, "
    "60]]";

TEST_F(FieldComparison, ReadsWhatItSays) {
  const Comparison comparison = read(
      "start: south_west\nend: free\nparts: {width_m: 10, method: boustrophedon, slice_deg: 90}\n"
      "fields:\n  - " +
      kU +
      ", entry: [1, 1], start: entry, end: [95, 10]}\n  - {name: made, count: 2, generator: "
      "{parts: 5, seed: 4}, parts: {method: convex, least_area_m2: 3, small_parts: merge, merge: "
      "true}}\nplanners: [{name: region_de, scaling: 0.5, sweeps: any}]\n");
  ASSERT_EQ(comparison.maps.size(), 3U);
  EXPECT_TRUE(is_of_fields(comparison));
  EXPECT_EQ(comparison.maps[2].name, "made_2");
  const ComparedRegion& u = *comparison.maps[0].region;
  EXPECT_EQ(u.start_W, Eigen::Vector2d(1, 1));
  EXPECT_EQ(u.end_W, Eigen::Vector2d(95, 10));
  EXPECT_EQ(u.parts.parts.size(), 1U);  // slices along the arms split nowhere
  const ComparedRegion& made = *comparison.maps[1].region;
  EXPECT_EQ(made.field.boundary, made_up_region({5, -1, 3e5, 4}, "").boundary);
  EXPECT_EQ(made.options.decomposition, Decomposition::kConvex);
  EXPECT_EQ(made.options.width_m, 10.0);
  EXPECT_EQ(made.options.least_m2, 3.0);
  EXPECT_EQ(made.options.small, SmallParts::kMerge);
  EXPECT_TRUE(made.options.merge);
  double west = 0.0;
  for (const Eigen::Vector2d& p_W : made.field.boundary) west = std::min(west, p_W.x());
  EXPECT_EQ(made.start_W->x(), west);
  EXPECT_FALSE(made.end_W);
  const ComparedPlanner& planner = comparison.planners[0];
  EXPECT_EQ(planner.stop.iterations, 150);
  EXPECT_EQ(planner.sweeps, PartSweeps::kAny);
  EXPECT_EQ(number(planner.parameters, "scaling"), 0.5);
}

TEST_F(FieldComparison, GapsAreThoseToTheShortestPlan) {
  Comparison comparison =
      read("repeats: 2\nstop: {iterations: 10}\n" + kFourParts + kRegionPlanners);
  prove_least_costs(comparison, {2, {}, {}});
  const ComparedRegion& region = *comparison.maps[0].region;
  ASSERT_TRUE(region.least_own && region.least_any);
  EXPECT_LE(*region.least_any, *region.least_own + kLengthSum_m);
  const ComparedFigure& gap = find_figure("gap", "test", "");
  for (const ComparedRun& run : run_comparison(comparison, {2, {}, {}})) {
    ASSERT_EQ(run.state, RunState::kPlanned);
    const double least_m = run.planner == 2 ? *region.least_any : *region.least_own;
    EXPECT_NEAR(gap.value(run), run.region.cost / least_m - 1.0, 1e-12);
    EXPECT_GE(gap.value(run), -1e-9);
    if (run.planner == 1) {
      EXPECT_NEAR(gap.value(run), 0.0, 1e-9);
    }
    const PartSweeps sweeps = comparison.planners[static_cast<std::size_t>(run.planner)].sweeps;
    EXPECT_NEAR(run.region.cost, plan_cost(region_problem(region, sweeps), run.region.visits),
                kLengthSum_m);
  }
}

// With a file of measured costs plans are reckoned in W h over the field's own ground; no plan is
// cheaper than the proven one.
TEST_F(FieldComparison, IsOfEnergyByMeasuredCosts) {
  written("costs.yaml", cost_table_yaml(made_up_table()));
  Comparison comparison =
      read("repeats: 1\nstop: {iterations: 10}\ncost: costs.yaml\nparts: {width_m: 10}\nfields: [" +
           kU + ", terrain: {generator: ramp, slope_percent: 5}}]\n" + kRegionPlanners);
  prove_least_costs(comparison, {1, {}, {}});
  const ComparedRegion& region = *comparison.maps[0].region;
  ASSERT_TRUE(region.cost && region.terrain && region.least_own);
  for (const ComparedRun& run : run_comparison(comparison, {1, {}, {}})) {
    ASSERT_EQ(run.state, RunState::kPlanned) << run.refusal;
    EXPECT_GE(search_of(run).cost,
              (run.planner == 2 ? *region.least_any : *region.least_own) - kLengthSum_m);
  }
  const nlohmann::ordered_json json =
      comparison_json(comparison, run_comparison(comparison, {1, {}, {}}), {}, "0");
  EXPECT_EQ(json["comparison"]["cost"]["objective"], "measured");
  EXPECT_EQ(json["comparison"]["fields"][0]["least_energy_wh"]["own"], *region.least_own);
}

TEST_F(FieldComparison, HasNoGapWhereNothingIsProven) {
  Comparison comparison = read(
      "repeats: 1\nstop: {iterations: 1}\nparts: {width_m: 40}\n"
      "fields: [{generator: {parts: 30}}]\n" +
      kRegionPlanners);
  prove_least_costs(comparison, {1, {}, {}});
  const auto runs = run_comparison(comparison, {1, {}, {}});
  const ComparedFigure& gap = find_figure("gap", "test", "");
  EXPECT_FALSE(has_figure(gap, runs[0]));
  EXPECT_TRUE(has_figure(find_figure("cost", "test", ""), runs[0]));
  // The exact planner says why it does not plan that field.
  EXPECT_EQ(runs[1].state, RunState::kRefused);
  EXPECT_THAT(runs[1].refusal, HasSubstr("region_local_search does without"));
}

TEST_F(FieldComparison, FilesNameFieldsPartsAndVisits) {
  Comparison comparison = read(
      "repeats: 2\nstop: {iterations: 5}\nparts: {width_m: 10, least_area_m2: 700}\nfields: [" +
      kU + "}]\n" + kRegionPlanners);
  const auto runs = run_comparison(comparison, {1, {}, {}});
  const auto json = comparison_json(comparison, runs, rank_planners(comparison, runs), "0");
  const auto& field = json["comparison"]["fields"][0];
  EXPECT_EQ(field["name"], "u");
  EXPECT_EQ(field["parts"].size(), 3U);
  EXPECT_EQ(field["dropped_parts"], 0);
  EXPECT_EQ(json["comparison"]["planners"][2]["sweeps"], "any");
  const auto& best = json["results"][0]["best"]["visits"];
  ASSERT_EQ(best.size(), 3U);
  EXPECT_EQ(best[0]["entry"].size(), 2U);
  EXPECT_THAT(comparison_runs_csv(comparison, runs),
              testing::StartsWith("field,planner,repeat,seed,state,stopped_by,refusal,cost,gap,"));
  EXPECT_THAT(comparison_table_csv(comparison, runs), HasSubstr(",cost_median,"));
}

TEST_F(FieldComparison, RefusesWhatItCannotCompare) {
  const std::string good = kFourParts + kRegionPlanners;
  EXPECT_THAT(refused("maps: [{generator: {}}]\n" + good), HasSubstr("maps: not with fields"));
  EXPECT_THAT(refused(good + "cost: {objective: length}\n"),
              HasSubstr("cost: with fields only a file of measured costs"));
  EXPECT_THAT(refused(good + "drive: {vehicle: transplanter}\n"),
              HasSubstr("drive: not with fields"));
  EXPECT_THAT(
      refused("planners: [{name: region_iga, population: 5, least_population: 6}]\n" + kFourParts),
      HasSubstr("line 1: planners.least_population: '6': at most 5, the population"));
  EXPECT_THAT(refused("fields: []\n" + kRegionPlanners), HasSubstr("at least one field"));
  EXPECT_THAT(refused("fields: [{generator: {}}]\n" + kRegionPlanners),
              HasSubstr("parts.width_m, the width of a swath, is needed"));
  EXPECT_THAT(refused("fields: [{name: x}]\n" + kRegionPlanners),
              HasSubstr("one of file, boundary, generator is needed, and no two"));
  EXPECT_THAT(refused("fields: [" + kU + ", count: 3}]\n" + kRegionPlanners),
              HasSubstr("count: only with generator"));
  EXPECT_THAT(
      refused("parts: {width_m: 10}\nfields: [" + kU + ", start: entry}]\n" + kRegionPlanners),
      HasSubstr("start: 'entry': this field has no entry"));
  EXPECT_THAT(refused(good + "start: norths\n"), HasSubstr("'norths': a point [x, y] in metres"));
  EXPECT_THAT(refused("parts: {width_m: 10, least_area_m2: 1e5}\nfields: [" + kU + "}]\n" +
                      kRegionPlanners),
              HasSubstr("'u': parts.least_area_m2: '100000': no part of the field is that large"));
  EXPECT_THAT(refused("parts: {width_m: 40, method: convexe}\nfields: [{generator: {}}]\n" +
                      kRegionPlanners),
              HasSubstr("parts.method: 'convexe': unknown word; did you mean 'convex'?"));
  EXPECT_THAT(refused(kFourParts + "planners: [{name: grid_tplp}]\n"),
              HasSubstr("'grid_tplp': unknown planner; did you mean 'region_"));
  EXPECT_THAT(refused(kFourParts + "planners: [{name: region_iga, sweeps: all}]\n"),
              HasSubstr("sweeps: 'all': unknown word"));
  EXPECT_THAT(refused(good + "tests: {figure: turns}\n"),
              HasSubstr("'turns': no figure of plans on fields"));
  EXPECT_THAT(refused("maps: [{generator: {}}]\nparts: {width_m: 3}\n"
                      "planners: [{name: grid_tplp}]\n"),
              HasSubstr("parts: only with fields"));
  EXPECT_THAT(refused("maps: [{generator: {}}]\nplanners: [{name: grid_tplp}]\n"
                      "tests: {figure: gap}\n"),
              HasSubstr("'gap': no figure of plans on grid maps"));
}

TEST(FieldComparisonDocs, TheExampleIsRead) {
  const Comparison comparison =
      read_comparison(HEADLAND_SOURCE_DIR "/examples/compare_fields.yaml");
  EXPECT_TRUE(is_of_fields(comparison));
  EXPECT_GE(comparison.maps.size(), 5U);  // enough for the tests it asks for
}

}  // namespace
}  // namespace headland
