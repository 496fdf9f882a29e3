#include "evaluate/tuning.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "evaluate/plan_scenario.h"
#include "evaluate/run_key.h"
#include "evaluate/tuned_weights.h"
#include "evaluate/tuning_file.h"
#include "tests/evaluate/made_up_costs.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const std::string kHead =
    "vehicle: transplanter\n"
    "costs: costs.yaml\n"
    "forms: [tractor, length, measured]\n"
    "planner: {name: grid_local_search, stop: {iterations: 3}}\n"
    "plans: {planners: [grid_boustrophedon, grid_local_search], variations: 4, iterations: 3, "
    "perturbed: 2}\n"
    "bootstrap: 100\n"
    "shuffles: 1\n"
    "simulation: {rate_hz: 60, record_hz: 1}\n"
    "coverage: {cell_m: 1}\n";
const std::string kTerrain =
    "  terrains: {hill: {generator: rolling, amplitude_m: 0.5, wavelength_m: 30, cell_m: 1}}\n";
const std::string kTraining = "training:\n  fields: {square: {grid_map: square.txt}}\n" + kTerrain;
const std::string kHeldOut = "held_out:\n  fields: {hook: {grid_map: hook.txt}}\n" + kTerrain;

class TuningTest : public ScratchFolder {
 protected:
  void SetUp() override {
    written("square.txt", "....\n....\n....\n");
    written("hook.txt", "....\n.#..\n....\n");
    written("costs.yaml", cost_table_yaml(made_up_table()));
  }
  std::string said(const std::string& text) const {
    return refusal([&] { read_tuning(written("tune.yaml", text)); });
  }
};

TEST_F(TuningTest, RefusesSetsThatProveNothing) {
  EXPECT_EQ(said(kHead + kTraining + kHeldOut), "accepted");
  EXPECT_THAT(said(kHead + kTraining), HasSubstr("held_out: missing: weights are fitted on"));
  EXPECT_THAT(said(kHead + kHeldOut), HasSubstr("training: missing: "));
  // The same map under another name and in another file.
  written("copy.txt", "....\n....\n....\n");
  EXPECT_THAT(
      said(kHead + kTraining + "held_out: {fields: {other: {grid_map: copy.txt}}}\n"),
      HasSubstr("line 13: held_out.fields: 'other': fields that are not in training are needed; "
                "this is its square"));
}

TEST_F(TuningTest, RefusesWhatItCannotTune) {
  const std::string sets = kTraining + kHeldOut;
  EXPECT_THAT(said(sets), HasSubstr("vehicle: missing"));
  EXPECT_THAT(said("vehicle: transplanter\nplanner: {name: boustrophedon}\n" + sets),
              HasSubstr("a planner on grid maps is needed: others have no weights"));
  EXPECT_THAT(said("vehicle: transplanter\nforms: [weigted]\n" + sets),
              HasSubstr("forms: 'weigted': one of weighted, tractor, length, measured"));
  EXPECT_THAT(said("vehicle: transplanter\nplans: {planners: [grid_igga]}\n" + sets),
              HasSubstr("line 2: plans.planners: 'grid_igga': unknown planner; did you mean "
                        "'grid_iga'?"));
  EXPECT_THAT(
      said("vehicle: transplanter\nplanner: {name: grid_iga, cost: {objective: length}}\n" + sets),
      HasSubstr("line 2: planner.cost: not here"));
  EXPECT_THAT(said("vehicle: transplanter\nserch: {evaluations: 3}\n" + sets), HasSubstr("search"));
  EXPECT_THAT(said("vehicle: transplanter\nbootstrap: 1\n" + sets), HasSubstr("bootstrap"));
}

// On level ground no plan climbs: told by planning alone, before anything is driven, by line.
TEST_F(TuningTest, RefusesWhatCannotBeFittedBeforeAnyDrive) {
  const std::string level = "training:\n  fields: {square: {grid_map: square.txt}}\n";
  const Tuning tuning = read_tuning(written("tune.yaml", kHead + level + kHeldOut));
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  EXPECT_THAT(refusal([&] { run_tuning(tuning, store, {}); }),
              HasSubstr("line 10: training: 'climb': in no training plan, so that tractor cannot "
                        "be fitted"));
  const Statement row = prepare(store.database, "SELECT count(*) FROM results");
  ASSERT_TRUE(step(row));
  EXPECT_EQ(number_at(row, 0), 0.0);
  const Tuning few = read_tuning(written(
      "tune.yaml",
      "plans: {planners: [grid_boustrophedon], perturbed: 0}\nvehicle: transplanter\ncosts: "
      "costs.yaml\n" +
          kTraining + kHeldOut));
  EXPECT_THAT(refusal([&] { run_tuning(few, store, {}); }),
              HasSubstr("training: '1 plans': at least 4 are needed to fit weighted: cells, "
                        "repeats, turns, U-turns"));
}

// Of another vehicle, or no costs at all: before anything is driven, too.
TEST_F(TuningTest, RefusesCostsThatAreNoneBeforeAnyDrive) {
  written("costs.yaml", "vehicle: transplanter\n");
  const Tuning tuning = read_tuning(written("tune.yaml", kHead + kTraining + kHeldOut));
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  EXPECT_THAT(refusal([&] { run_tuning(tuning, store, {}); }), HasSubstr("costs.yaml: line 1"));
}

TEST_F(TuningTest, EveryKeyIsDocumented) {
  std::ifstream stream(HEADLAND_SOURCE_DIR "/docs/tune.md");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  for (const std::string& key : tuning_key_paths()) {
    EXPECT_THAT(text, HasSubstr("`" + key + "`"));
  }
}

// More of them would count one plan several times.
TEST_F(TuningTest, TrainsOnceByWhatHasNoWeights) {
  Tuning tuning = read_tuning(written("tune.yaml", kHead + kTraining + kHeldOut));
  const std::vector<TunedMethod> few = training_methods(tuning);
  tuning.perturbed = 0;
  tuning.variations = 10;
  const std::vector<TunedMethod> methods = training_methods(tuning);
  ASSERT_THAT(methods, SizeIs(11));
  std::map<GridObjective, int> times;
  for (const TunedMethod& method : methods) ++times[method.planner.grid->cost.objective];
  EXPECT_EQ(times[GridObjective::kLength], 1);
  EXPECT_EQ(times[GridObjective::kMeasured], 1);
  EXPECT_EQ(times[GridObjective::kWeighted] + times[GridObjective::kTractor], 9);
  for (std::size_t i = 0; i + 2 < few.size(); ++i) {  // without the perturbed
    const GridCost& one = few[i].planner.grid->cost;
    const GridCost& other = methods[i].planner.grid->cost;
    EXPECT_EQ(one.objective, other.objective);
    EXPECT_EQ(one.weights.turn, other.weights.turn);
    EXPECT_EQ(one.tractor.turn_weight, other.tractor.turn_weight);
  }
}

// Each is a run of its own, the same for the same seed and as many more come after it.
TEST_F(TuningTest, PerturbsPlansThatItMakes) {
  Tuning tuning = read_tuning(written("tune.yaml", kHead + kTraining + kHeldOut));
  const auto keys_of = [&] {
    const Sweep sweep = sweep_by(tuning.training, "made up", training_methods(tuning));
    std::vector<std::string> keys;
    ContentDigests digests;
    for (const Scenario& scenario : sweep.scenarios) keys.push_back(run_key(scenario, digests));
    return keys;
  };
  constexpr std::size_t kMade = 5;  // rows, and four searches
  tuning.perturbed = 20;
  const std::vector<std::string> keys = keys_of();
  ASSERT_THAT(keys, SizeIs(kMade + 20));
  EXPECT_EQ(std::set<std::string>(keys.begin(), keys.end()).size(), keys.size());
  EXPECT_EQ(keys_of(), keys);
  tuning.perturbed = 2;
  EXPECT_EQ(keys_of(), std::vector<std::string>(keys.begin(), keys.begin() + kMade + 2));
  // Control: what is not perturbed is the planners' alone, and another seed perturbs otherwise.
  const std::vector<TunedMethod> methods = training_methods(tuning);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Perturbation& perturb = methods[i].planner.grid->perturb;
    EXPECT_EQ(perturb.changes > 0, i >= kMade) << methods[i].label;
  }
  tuning.seed = 2;
  EXPECT_NE(training_methods(tuning).back().planner.grid->perturb.seed,
            methods.back().planner.grid->perturb.seed);
}

TEST_F(TuningTest, TakesNoEnergyForOneThatIsNone) {
  const Tuning tuning = read_tuning(written("tune.yaml", kHead + kTraining + kHeldOut));
  const Sweep sweep = sweep_by(tuning.training, "made up", training_methods(tuning));
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  const std::vector<double> energies_wh = {7.0, 0.0, std::nan(""), -1.0, 5.0};
  std::vector<SweepCell> cells;
  for (std::size_t place = 0; place < energies_wh.size(); ++place) {
    cells.push_back(cell_at(sweep, place));
    cells.back().key = fmt::format("{}", place);
    StoredRun stored{cells.back().key, "", {}};
    stored.run.end = RunEnd::kDriven;
    stored.run.outcome = Outcome::kFinished;
    stored.run.figures.assign(run_figure_keys().size(), 1.0);
    stored.run.figures[run_figure_place("energy_wh")] = energies_wh[place];
    stored.run.figures[run_figure_place("grid_jumps")] = 0.0;
    keep_run(store, stored);
  }
  keep_cells(store, sweep.name, cells);
  // A row that is not there moves no other one.
  execute(store.database, "DELETE FROM cells WHERE place = 0");
  const std::vector<PlanRun> plans = plan_runs(sweep, store);
  ASSERT_THAT(plans, SizeIs(4));
  for (std::size_t i = 0; i < plans.size(); ++i) {
    EXPECT_EQ(plans[i].place, i + 1);
    EXPECT_EQ(plans[i].method, cells[i + 1].planner);
    EXPECT_EQ(plans[i].fault, i < 3 ? "its energy is no positive number" : "");
  }
  EXPECT_THAT(fit_plans(plans), SizeIs(1));
}

// Drives a tiny tuning, and again with the same store, which drives nothing.
TEST_F(TuningTest, FitsAndProvesAndGoesOnWhereItWas) {
  const Tuning tuning = read_tuning(written("tune.yaml", kHead + kTraining + kHeldOut));
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  const TuneResult result = run_tuning(tuning, store, {});
  EXPECT_EQ(result.training.runs, 7);  // rows, four searches and two perturbed plans
  EXPECT_EQ(result.training.driven_now, 7);
  EXPECT_EQ(result.training.faults, 0) << result.training.why.front();
  ASSERT_THAT(result.forms, SizeIs(3));
  EXPECT_EQ(result.best_label, "Wang et al. fitted");
  std::vector<std::string> methods;
  for (const MethodFigures& figures : result.figures) methods.push_back(figures.method);
  EXPECT_THAT(methods,
              ElementsAre("boustrophedon", "length", "Wu et al. weights", "Wang et al. weights",
                          "Wang et al. fitted", "measured costs", "shuffled"));
  const Saving* saving = energy_saving(result.figures[5], methods::kRows);
  ASSERT_NE(saving, nullptr);
  EXPECT_EQ(saving->blocks, 1);
  for (const PlanRun& plan : result.held_out_plans) EXPECT_GT(plan.predicted_wh, 0.0);

  // One field tells no interval.
  const auto json = tuning_json(tuning, result, "1");
  const auto& told = json["methods"][5]["saves_over"][std::string(methods::kRows)][0];
  EXPECT_TRUE(told["ci95_ratio"].is_null()) << told;
  EXPECT_TRUE(told["mean_ratio"].is_number()) << told;

  const TuneResult again = run_tuning(tuning, store, {});
  EXPECT_EQ(again.training.driven_now + again.held_out.driven_now, 0);
  EXPECT_EQ(tuning_json(tuning, again, "1"), tuning_json(tuning, result, "1"));
}

TEST_F(TuningTest, EndsEarlyWhenAsked) {
  const Tuning tuning = read_tuning(written("tune.yaml", kHead + kTraining + kHeldOut));
  RunStore store;
  open_run_store(path("runs.db"), DatabaseMode::kWrite, store);
  TuneOptions options;
  options.cancelled = [] { return true; };
  EXPECT_THROW(run_tuning(tuning, store, options), Cancelled);
}

// The same plan as without costs, in steps, and its energy besides.
TEST_F(TuningTest, TellsEnergyWithoutPlanningByIt) {
  const std::filesystem::path file =
      written("scenario.yaml",
              "vehicle: transplanter\nfield: {grid_map: square.txt}\n"
              "planner: {name: grid_boustrophedon, predict: costs.yaml}\n");
  const Scenario scenario = read_scenario(file);
  const PlanResult planned = plan_scenario(scenario, load_stage(scenario));
  EXPECT_EQ(planned.grid_plan->cost, planned.grid_plan->counts.steps);
  ASSERT_TRUE(planned.predicted.has_value());
  EXPECT_GT(planned.predicted->energy_wh, 0.0);
  const Scenario again = read_scenario(written("again.yaml", scenario_yaml(scenario)));
  EXPECT_EQ(again.planner.predict_file, scenario.planner.predict_file);
}

TEST_F(TuningTest, WeightsGoIntoAFileAndBack) {
  GridCost cost;
  cost.objective = GridObjective::kWeighted;
  cost.weights = {0.25, 1.0 / 3.0, 4.0};
  PlannerChoice planner;
  planner.name = "grid_iga";
  planner.grid.emplace();
  planner.cost_file = "costs.yaml";
  const std::filesystem::path file = written("weights.yaml", weights_yaml(cost, "a\nb"));
  plan_by_weights(file, planner);
  EXPECT_EQ(planner.grid->cost.objective, GridObjective::kWeighted);
  EXPECT_EQ(planner.grid->cost.weights.turn, cost.weights.turn);
  EXPECT_TRUE(planner.cost_file.empty());

  PlannerChoice rows;
  EXPECT_THAT(refusal([&] { plan_by_weights(file, rows); }),
              HasSubstr("only for planners on grid maps; boustrophedon has no weights"));
  const auto said_of = [&](const std::string& text) {
    return refusal([&] { plan_by_weights(written("bad.yaml", text), planner); });
  };
  EXPECT_THAT(said_of("cost: {objective: weighted, turn: -1}\n"), HasSubstr("cost.turn: '-1'"));
  EXPECT_THAT(said_of("weights: {}\n"), HasSubstr("weights"));
  EXPECT_THAT(said_of("cost: {file: costs.yaml}\n"), HasSubstr("measured costs go by --cost"));
}

}  // namespace
}  // namespace headland
