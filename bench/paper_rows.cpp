#include "bench/paper_rows.h"

#include <fmt/format.h>

#include <array>

namespace headland::bench {
namespace {

constexpr std::array<std::string_view, 6> kAlgorithms = {"grid_aco",   "grid_gwo",  "grid_spbo",
                                                         "grid_djaya", "grid_dtsa", "grid_tplp"};

PaperRow tplp_row(std::string_view table, const std::string& name, const Parameters& parameters,
                  double mean, double deviation) {
  return {table,
          name,
          "env_I",
          "grid_tplp",
          parameters,
          GridObjective::kLength,
          {{Quantity::kSteps, mean, deviation}}};
}

void add_parameter_rows(std::vector<PaperRow>& rows) {
  struct OfOne {
    double value;
    double mean;
    double deviation;
  };
  for (const OfOne& row :
       {OfOne{0.1, 372.4, 5.317}, OfOne{0.5, 372.8, 4.341}, OfOne{1.0, 372.2, 2.743},
        OfOne{2.0, 371.4, 4.812}, OfOne{5.0, 368.8, 2.348}, OfOne{10.0, 371.2, 4.341},
        OfOne{20.0, 370.6, 2.503}, OfOne{50.0, 371.0, 4.028}}) {
    rows.push_back(tplp_row("000 Table 4", fmt::format("lambda {}", row.value),
                            {{"lambda", row.value}}, row.mean, row.deviation));
  }
  for (const OfOne& row :
       {OfOne{0.5, 383.2, 5.750}, OfOne{0.6, 381.4, 5.502}, OfOne{0.7, 381.0, 5.598},
        OfOne{0.8, 376.0, 3.399}, OfOne{0.9, 372.8, 4.733}, OfOne{1.0, 368.8, 2.348}}) {
    rows.push_back(tplp_row("000 Table 5", fmt::format("alpha_g {}", row.value),
                            {{"alpha_g", row.value}}, row.mean, row.deviation));
  }
  struct OfShares {
    std::array<double, 3> shares;
    double mean;
    double deviation;
  };
  for (const OfShares& row :
       {OfShares{{0.5, 1.5, 3.0}, 366.2, 3.327}, OfShares{{1.0, 1.0, 1.0}, 365.8, 2.394},
        OfShares{{1.0, 2.0, 1.0}, 366.0, 2.494}, OfShares{{1.0, 2.0, 2.0}, 363.6, 2.271},
        OfShares{{2.0, 1.0, 1.0}, 372.8, 4.341}, OfShares{{2.0, 1.0, 2.0}, 362.8, 3.327},
        OfShares{{2.0, 2.0, 1.0}, 362.4, 2.836}, OfShares{{2.5, 1.5, 1.0}, 366.0, 4.320}}) {
    const auto& [two, three, four] = row.shares;
    rows.push_back(tplp_row("000 Table 6", fmt::format("shares {}:{}:{}", two, three, four),
                            {{"share_2", two}, {"share_3", three}, {"share_4", four}}, row.mean,
                            row.deviation));
  }
}

void add_map_rows(std::vector<PaperRow>& rows) {
  struct OfMap {
    std::string_view map;
    std::array<double, 6> means;
    std::array<double, 6> deviations;
  };
  // Environment III repeats II's rows from SPBO on; only TPLP's mean follows from the text.
  for (const OfMap& of : {OfMap{"env_I",
                                {435.6, 371.4, 386.0, 391.2, 371.8, 367.0},
                                {12.322, 5.064, 5.586, 12.218, 4.050, 2.366}},
                          OfMap{"env_II",
                                {1044.6, 859.8, 906.0, 896.5, 882.6, 832.6},
                                {19.323, 10.042, 10.284, 18.368, 17.640, 4.115}},
                          OfMap{"env_III",
                                {1505.8, 1217.8, -1.0, -1.0, -1.0, 1160.8},
                                {11.980, 19.966, -1.0, -1.0, -1.0, -1.0}},
                          OfMap{"env_IV",
                                {1710.6, 1393.46, 1479.4, 1447.5, 1403.9, 1330.2},
                                {9.800, 16.400, 13.500, 21.246, 19.445, 7.083}}}) {
    for (std::size_t i = 0; i < kAlgorithms.size(); ++i) {
      rows.push_back({"000 Table 8",
                      fmt::format("{} {}", of.map, kAlgorithms[i]),
                      of.map,
                      kAlgorithms[i],
                      {},
                      GridObjective::kLength,
                      {{Quantity::kSteps, of.means[i], of.deviations[i]}}});
    }
    rows.push_back({"000 Table 8",
                    fmt::format("{} grid_local_search", of.map),
                    of.map,
                    "grid_local_search",
                    {},
                    GridObjective::kLength,
                    {{}}});
  }
}

void add_tractor_rows(std::vector<PaperRow>& rows) {
  struct OfTractor {
    double length;
    double length_deviation;
    double fitness;
    double fitness_deviation;
  };
  constexpr std::array<OfTractor, 6> kPrinted = {{{302.5, 6.771, 3.777e-3, 7.225e-5},
                                                  {267.7, 3.389, 3.951e-3, 7.323e-5},
                                                  {273.8, 3.833, 3.876e-3, 6.854e-5},
                                                  {288.3, 10.183, 4.070e-3, 1.986e-5},
                                                  {293.9, 8.813, 4.135e-3, 8.124e-5},
                                                  {265.9, 2.382, 4.155e-3, 3.091e-5}}};
  for (std::size_t i = 0; i < kAlgorithms.size(); ++i) {
    const OfTractor& of = kPrinted[i];
    rows.push_back({"000 Table 9",
                    std::string(kAlgorithms[i]),
                    "tractor",
                    kAlgorithms[i],
                    {},
                    GridObjective::kTractor,
                    {{Quantity::kSteps, of.length, of.length_deviation},
                     {Quantity::kFitness, of.fitness, of.fitness_deviation}}});
  }
}

}  // namespace

std::vector<PaperRow> wang_rows() {
  std::vector<PaperRow> rows;
  add_parameter_rows(rows);
  add_map_rows(rows);
  add_tractor_rows(rows);
  return rows;
}

std::vector<PaperRow> wu_rows() {
  struct OfField {
    std::string_view map;
    std::array<double, 3> by_rows;  // repeats [m2], turns, U-turns of boustrophedon
    std::array<double, 3> by_iga;
    double multi;  // Figure 15: fitness after 1000 generations
    double single;
  };
  std::vector<PaperRow> rows;
  for (const OfField& of : {OfField{"field_A", {0, 22, 0}, {0, 22, 0}, 0.22727, 0.16393},
                            OfField{"field_B", {32, 32, 1}, {4, 47, 0}, 0.18519, 0.12048},
                            OfField{"field_C", {16, 26, 4}, {16, 22, 4}, 0.26316, 0.15625},
                            OfField{"field_D", {36, 34, 5}, {12, 42, 3}, 0.11364, 0.09804}}) {
    const auto table_row = [&](std::string_view planner, const std::array<double, 3>& printed) {
      rows.push_back({"001 Table 1",
                      fmt::format("{} {}", of.map, planner),
                      of.map,
                      planner,
                      {},
                      GridObjective::kWeighted,
                      {{Quantity::kRepeats_m2, printed[0]},
                       {Quantity::kTurns, printed[1]},
                       {Quantity::kUTurns, printed[2]}}});
    };
    table_row("grid_boustrophedon", of.by_rows);
    table_row("grid_iga", of.by_iga);
    for (const auto& [points, printed] :
         {std::pair{"multi", of.multi}, std::pair{"single", of.single}}) {
      rows.push_back({"001 Figure 15",
                      fmt::format("{} {}", of.map, points),
                      of.map,
                      "grid_iga",
                      {{"mutation_points", std::string(points)}},
                      GridObjective::kWeighted,
                      {{Quantity::kFitness, printed}}});
    }
  }
  return rows;
}

std::vector<TableNote> table_notes() {
  return {
      {"000 Table 2",
       "the paper's map is not published, ours has its size, share and number of obstacles; our "
       "ants see cells within 3 steps only, and greedy orders end in a given corner"},
      {"000 Table 3",
       "changes that make an order no longer are kept, those of equal length too, where the paper "
       "does not say; SPBO's acting on orders is our reading, and as good"},
      {"000 Table 4",
       "with alpha_g = 1 no cell is drawn by lambda: the paper's figures differ by chance; ours "
       "end at the least length there is"},
      {"000 Table 5", "as Table 4: keeping changes of equal length makes good what begins badly"},
      {"000 Table 6", "as Table 4"},
      {"000 Table 8",
       "maps are not the paper's; rivals begin greedily and keep changes of equal length as TPLP "
       "does; environment III's rows repeat II's in the paper and are left out"},
      {"000 Table 9",
       "neither map nor heights are published; slopes are those of steps, where the paper's Eq 15 "
       "takes a cell's height for its slope, and rivals begin greedily"},
      {"001 Table 1",
       "IGA as described does not come near its printed results: a random order of all cells is "
       "improved by rare random exchanges, and stagnation ends it; boustrophedon is exact"},
      {"001 Table 2", "follows from Table 1"},
      {"001 Figure 15", "as Table 1"},
  };
}

}  // namespace headland::bench
