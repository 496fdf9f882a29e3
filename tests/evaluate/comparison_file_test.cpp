#include "evaluate/comparison_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "evaluate/comparison_figures.h"
#include "terrains/grid_map_generator.h"
#include "tests/terrains/refusal.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

using ::testing::HasSubstr;

class ComparisonFile : public ScratchFolder {
 protected:
  Comparison read(const std::string& text) const {
    return read_comparison(written("compare.yaml", text));
  }
  // Without the folder's name.
  std::string refused(const std::string& text) const {
    std::string said = refusal([&] { read(text); });
    const std::string folder = path("").string();
    for (auto at = said.find(folder); at != std::string::npos; at = said.find(folder)) {
      said.erase(at, folder.size());
    }
    return said;
  }
};

const std::string kOneMap = "maps: [{generator: {columns: 6, rows: 5}, name: small}]\n";
const std::string kTwoPlanners =
    "planners: [{name: grid_tplp, label: ours}, {name: grid_boustrophedon}]\n";

TEST_F(ComparisonFile, ReadsWhatItSays) {
  written("drawn.txt", "...\n.#.\n...\n");
  const Comparison comparison = read(
      "seed: 7\nrepeats: 4\nstart: north_west\n"
      "maps:\n  - {file: drawn.txt, cell_m: 2, end: [2, 0]}\n"
      "  - {name: many, count: 3, start: free, generator: {columns: 9, rows: 8, seed: 4}}\n"
      "cost: {objective: weighted, turn: 0.4}\n"
      "budget: {evaluations: 500}\n"
      "planners:\n  - {name: grid_tplp, population: 30}\n  - {name: grid_tplp, label: other}\n"
      "tests: {control: other, alpha: 0.1, blocks: runs, figure: length_steps}\n");
  ASSERT_EQ(comparison.maps.size(), 4U);
  EXPECT_EQ(comparison.maps[0].name, "drawn");
  EXPECT_EQ(comparison.maps[0].map.cell_m, 2.0);
  EXPECT_EQ(comparison.maps[0].start, (GridCell{0, 2}));
  EXPECT_EQ(comparison.maps[0].end, (GridCell{2, 0}));
  EXPECT_EQ(comparison.maps[3].name, "many_3");
  EXPECT_FALSE(comparison.maps[3].start);
  EXPECT_EQ(comparison.maps[2].map.blocked, made_up_grid_map({9, 8, 0.105, 3, 5}, "").blocked);
  EXPECT_EQ(comparison.cost.weights.turn, 0.4);
  EXPECT_EQ(number(comparison.planners[0].parameters, "population"), 30.0);
  EXPECT_EQ(comparison.planners[1].stop.evaluations, 500);
  EXPECT_EQ(comparison.planners[1].stop.iterations, std::numeric_limits<int>::max());
  EXPECT_EQ(comparison.tests.blocks, BlockKind::kRuns);
  EXPECT_EQ(comparison.seed, 7U);
  EXPECT_EQ(read_comparison(path("compare.yaml"), 8).seed, 8U);
}

TEST_F(ComparisonFile, TakesHeightsFromATerrainAndClosedTours) {
  const Comparison comparison = read(
      "closed: true\n"
      "maps:\n  - {name: hill, generator: {columns: 6, rows: 5}, cell_m: 3,\n"
      "     terrain: {generator: ramp, slope_percent: 10}}\n"
      "  - {name: way, closed: false, start: [0, 0], end: [5, 4],\n"
      "     generator: {columns: 6, rows: 5}}\n" +
      kTwoPlanners);
  const GridMap& hill = comparison.maps[0].map;
  ASSERT_EQ(hill.height_m.size(), hill.blocked.size());
  // A plane: any two neighbours of a row differ alike, those of a column too.
  const double rise_m = hill.height_m[1] - hill.height_m[0];
  const double across_m = hill.height_m[6] - hill.height_m[0];
  EXPECT_NEAR(std::hypot(rise_m, across_m), 0.1 * 3.0, 1e-6);
  EXPECT_NEAR(hill.height_m[5] - hill.height_m[0], 5.0 * rise_m, 1e-6);
  EXPECT_TRUE(comparison.maps[0].closed);
  EXPECT_FALSE(comparison.maps[1].closed);
  for (const ComparedRun& run : run_comparison(comparison, {})) {
    const auto& cells = run.plan.cells;
    ASSERT_EQ(run.state, RunState::kPlanned) << run.refusal;
    EXPECT_EQ(cells.front() == cells.back(),
              comparison.maps[static_cast<std::size_t>(run.map)].closed);
  }
  EXPECT_THAT(
      refused("maps: [{generator: {}, closed: true, start: [0, 0], end: [1, 0]}]\n" + kTwoPlanners),
      HasSubstr("end: '1, 0': none, or the start: the tour is closed"));
  EXPECT_THAT(refused("maps: [{generator: {}, terrain: {generator: rampe}}]\n" + kTwoPlanners),
              HasSubstr("line 1: terrain.generator: 'rampe': unknown generator; did you mean"));
}

TEST_F(ComparisonFile, RefusesWhatItCannotCompare) {
  written("map.txt", "..#\n...\n");
  written("parted.txt", ".#.\n.#.\n");
  const std::string map = "maps: [{file: map.txt}]\n";
  const std::string both = map + kTwoPlanners;
  EXPECT_THAT(refused(both + "repeat: 3\n"), HasSubstr("unknown key; did you mean 'repeats'?"));
  EXPECT_THAT(refused(both + "repeats: 0\n"),
              HasSubstr("line 3: repeats: '0': a whole number from 1 to 10000 is needed"));
  EXPECT_THAT(refused(kTwoPlanners), HasSubstr("maps: a list with at least one map is needed"));
  EXPECT_THAT(refused(map), HasSubstr("planners: a list with at least one planner is needed"));
  EXPECT_THAT(refused("maps: [{file: none.txt}]\n" + kTwoPlanners),
              HasSubstr("maps.file: 'none.txt': no such file"));
  EXPECT_THAT(refused("maps: [{file: map.txt, generator: {}}]\n" + kTwoPlanners),
              HasSubstr("one of file, cells, generator, field is needed, and no two"));
  EXPECT_THAT(refused("maps: [{file: map.txt, count: 2}]\n" + kTwoPlanners),
              HasSubstr("maps.count: only with a generator"));
  EXPECT_THAT(refused("maps: [{file: map.txt, start: [2, 1]}]\n" + kTwoPlanners),
              HasSubstr("line 1: maps 'map': start: '2, 1'"));
  EXPECT_THAT(refused("maps: [{file: map.txt, start: [0, 5]}]\n" + kTwoPlanners),
              HasSubstr("maps 'map': start: '0, 5'"));
  EXPECT_THAT(refused(both + "start: north_east\n"), HasSubstr("maps 'map': start: '2, 1'"));
  EXPECT_THAT(refused(both + "start: norths\n"), HasSubstr("'norths': [column, row]"));
  EXPECT_THAT(refused("maps: [{file: map.txt, start: [0, 0], end: [0, 0]}]\n" + kTwoPlanners),
              HasSubstr("another cell than the start"));
  EXPECT_THAT(
      refused("maps: [{file: parted.txt}]\n" + kTwoPlanners),
      HasSubstr("maps 'parted': map: '2 of 4 free cells': cannot be reached from the rest"));
  EXPECT_THAT(refused("maps: [{file: map.txt}, {file: map.txt}]\n" + kTwoPlanners),
              HasSubstr("maps: 'map': the name stands twice"));
  EXPECT_THAT(refused("maps: [{generator: {columns: 5000}}]\n" + kTwoPlanners),
              HasSubstr("'5000': a whole number from 1 to 1000 is needed"));
  EXPECT_THAT(refused("maps: [{field: {file: map.txt}}]\n" + kTwoPlanners),
              HasSubstr("width_m: the key is missing"));
}

TEST_F(ComparisonFile, RefusesPlannersAndTestsThatAreNone) {
  EXPECT_THAT(refused(kOneMap + "planners: [{name: grid_tlpp}]\n"),
              HasSubstr("line 2: planners.name: 'grid_tlpp': unknown planner; did you mean "
                        "'grid_tplp'?"));
  EXPECT_THAT(refused(kOneMap + "planners: [{label: x}]\n"), HasSubstr("name: the key is missing"));
  EXPECT_THAT(refused(kOneMap + "planners: [{name: grid_tplp, populaton: 3}]\n"),
              HasSubstr("planners.populaton: unknown key; did you mean 'population'?"));
  EXPECT_THAT(refused(kOneMap + "planners: [{name: grid_tplp, population: 1}]\n"),
              HasSubstr("planners.population: '1': a whole number from"));
  EXPECT_THAT(refused(kOneMap + "planners: [{name: grid_tplp}, {name: grid_tplp}]\n"),
              HasSubstr("planners: 'grid_tplp': the label stands twice"));
  EXPECT_THAT(refused(kOneMap + "planners: [{name: grid_tplp, label: a b}, "
                                "{name: grid_tplp, label: a/b}]\n"),
              HasSubstr("'a/b': the label stands twice; in files,"));
  EXPECT_THAT(refused(kOneMap + "planners: [{name: grid_tplp, label: ../..}]\n"),
              HasSubstr("a label with a letter or a digit is needed"));
  const std::string both = kOneMap + kTwoPlanners;
  EXPECT_THAT(
      refused(both + "tests: {control: our}\n"),
      HasSubstr("tests.control: 'our': none of the planners' labels; did you mean 'ours'?"));
  EXPECT_THAT(refused(both + "tests: {figure: costs}\n"),
              HasSubstr("tests.figure: 'costs': unknown figure; the nearest is cost"));
  EXPECT_THAT(refused(both + "tests: {blocks: map}\n"), HasSubstr("did you mean 'maps'?"));
  EXPECT_THAT(refused(both + "tests: {figure: driven_time_s}\n"),
              HasSubstr("'driven_time_s': a figure of plans; only the best ones are driven"));
  EXPECT_THAT(refused(both + "drive: {soil: firm}\n"), HasSubstr("vehicle: the key is missing"));
  EXPECT_THAT(refused(both + "drive: {vehicle: transplanter, planner: {}}\n"),
              HasSubstr("line 3: planner: unknown key"));
  EXPECT_THAT(refused(both + "tests: {alpha: 2}\n"), HasSubstr("from 0.001 to 0.5"));
}

TEST_F(ComparisonFile, RefusesCostsAndEndsThatAreNone) {
  const std::string both = kOneMap + kTwoPlanners;
  EXPECT_THAT(refused(both + "cost: {objective: shortest}\n"), HasSubstr("unknown word"));
  EXPECT_THAT(refused(both + "cost: {turn: 1}\n"),
              HasSubstr("cost.turn: only with cost.objective: weighted"));
  EXPECT_THAT(refused(both + "cost: {objective: weighted, turn: -1}\n"),
              HasSubstr("cost.turn: '-1'"));
  EXPECT_THAT(refused(both + "cost: {objective: weighted, turn: 0, repeat: 0, u_turn: 0}\n"),
              HasSubstr("compare.yaml: line 3: cost.repeat: '0'"));
  EXPECT_THAT(refused(both + "cost: {objective: tractor, tractor: {mass_kg: 0}}\n"),
              HasSubstr("mass_kg"));
  EXPECT_THAT(refused(both + "stop: {iterations: 0}\n"), HasSubstr("stop.iterations: '0'"));
  EXPECT_THAT(refused(both + "stop: {iterations: 5}\nbudget: {seconds: 1}\n"),
              HasSubstr("either budget or stop, not both"));
  EXPECT_THAT(refused(both + "budget: {seconds: 1, evaluations: 5}\n"),
              HasSubstr("either budget.evaluations or budget.seconds is needed, and not both"));
  EXPECT_THAT(refused(kOneMap + "planners: [{name: grid_tplp, stop: {iterations: 2}}]\n"
                                "budget: {seconds: 1}\n"),
              HasSubstr("planners.stop: not with budget"));
}

TEST(ComparisonFileDocs, NameEveryKeyAndFigure) {
  std::ifstream file(HEADLAND_SOURCE_DIR "/docs/compare.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& key : comparison_key_paths())
    EXPECT_THAT(text, HasSubstr("`" + key + "`"));
  for (const ComparedFigure& figure : every_figure()) {
    EXPECT_THAT(text, HasSubstr("`" + std::string(figure.key) + "`"));
  }
}

TEST(ComparisonFileDocs, TheExampleIsRead) {
  const Comparison comparison = read_comparison(HEADLAND_SOURCE_DIR "/examples/compare.yaml");
  EXPECT_GE(comparison.maps.size(), 5U);  // enough for the tests it asks for
  EXPECT_EQ(comparison.tests.control, "TPLP");
}

}  // namespace
}  // namespace headland
