#include "bench/paper_rows.h"

#include <fmt/format.h>

#include <array>

namespace headland::bench {
namespace {

constexpr std::array<std::string_view, 6> kAlgorithms = {"grid_aco",   "grid_gwo",  "grid_spbo",
                                                         "grid_djaya", "grid_dtsa", "grid_tplp"};

// Printed mean and standard deviation; Crr in percent.
struct Two {
  double mean = kNotPrinted;
  double deviation = -1.0;
};

Printed of(Quantity quantity, const Two& two) { return {quantity, two.mean, two.deviation}; }

PaperRow tplp_row(std::string_view table, const std::string& name, const Parameters& parameters,
                  const Two& repeat_rate, const Two& steps) {
  return {table,
          name,
          "env_I",
          "grid_tplp",
          parameters,
          GridObjective::kLength,
          {of(Quantity::kRepeatRate, repeat_rate), of(Quantity::kSteps, steps)}};
}

void add_parameter_rows(std::vector<PaperRow>& rows) {
  struct OfOne {
    double value;
    Two repeat_rate;
    Two steps;
  };
  for (const OfOne& row :
       {OfOne{0.1, {4.30, 1.5}, {372.4, 5.317}}, OfOne{0.5, {4.39, 1.2}, {372.8, 4.341}},
        OfOne{1.0, {4.42, 0.7}, {372.2, 2.743}}, OfOne{2.0, {3.85, 1.3}, {371.4, 4.812}},
        OfOne{5.0, {3.29, 0.6}, {368.8, 2.348}}, OfOne{10.0, {3.91, 1.1}, {371.2, 4.341}},
        OfOne{20.0, {3.77, 1.1}, {370.6, 2.503}}, OfOne{50.0, {3.88, 1.2}, {371.0, 4.028}}}) {
    rows.push_back(tplp_row("000 Table 4", fmt::format("lambda {}", row.value),
                            {{"lambda", row.value}}, row.repeat_rate, row.steps));
  }
  for (const OfOne& row :
       {OfOne{0.5, {7.21, 1.7}, {383.2, 5.750}}, OfOne{0.6, {6.56, 1.5}, {381.4, 5.502}},
        OfOne{0.7, {6.68, 1.6}, {381.0, 5.598}}, OfOne{0.8, {5.31, 0.9}, {376.0, 3.399}},
        OfOne{0.9, {4.41, 1.3}, {372.8, 4.733}}, OfOne{1.0, {3.30, 0.6}, {368.8, 2.348}}}) {
    rows.push_back(tplp_row("000 Table 5", fmt::format("alpha_g {}", row.value),
                            {{"alpha_g", row.value}}, row.repeat_rate, row.steps));
  }
  struct OfShares {
    std::array<double, 3> shares;
    Two repeat_rate;
    Two steps;
  };
  for (const OfShares& row : {OfShares{{0.5, 1.5, 3.0}, {2.63, 0.9}, {366.2, 3.327}},
                              OfShares{{1.0, 1.0, 1.0}, {2.46, 0.7}, {365.8, 2.394}},
                              OfShares{{1.0, 2.0, 1.0}, {2.51, 0.7}, {366.0, 2.494}},
                              OfShares{{1.0, 2.0, 2.0}, {1.84, 0.6}, {363.6, 2.271}},
                              OfShares{{2.0, 1.0, 1.0}, {1.62, 0.8}, {372.8, 4.341}},
                              OfShares{{2.0, 1.0, 2.0}, {1.62, 0.9}, {362.8, 3.327}},
                              OfShares{{2.0, 2.0, 1.0}, {1.50, 0.8}, {362.4, 2.836}},
                              OfShares{{2.5, 1.5, 1.0}, {2.49, 1.2}, {366.0, 4.320}}}) {
    const auto& [two, three, four] = row.shares;
    rows.push_back(tplp_row("000 Table 6", fmt::format("shares {}:{}:{}", two, three, four),
                            {{"share_2", two}, {"share_3", three}, {"share_4", four}},
                            row.repeat_rate, row.steps));
  }
}

void add_map_rows(std::vector<PaperRow>& rows) {
  struct OfAlgorithm {
    Two repeat_rate;
    Two steps;
    double convergence = kNotPrinted;
  };
  struct OfMap {
    std::string_view map;
    std::array<OfAlgorithm, 6> algorithms;
  };
  // Environment III repeats II's rows from SPBO on but for the last column; only TPLP's means
  // follow from the text.
  for (const OfMap& on : {OfMap{"env_I",
                                {{{{19.05, 3.2}, {435.6, 12.322}, 433.4},
                                  {{3.93, 1.4}, {371.4, 5.064}, 494.4},
                                  {{8.10, 1.6}, {386.0, 5.586}, 567.0},
                                  {{11.98, 2.5}, {391.2, 12.218}, 457.4},
                                  {{6.96, 2.1}, {371.8, 4.050}, 398.9},
                                  {{2.79, 0.7}, {367.0, 2.366}, 312.3}}}},
                          OfMap{"env_II",
                                {{{{25.90, 2.8}, {1044.6, 19.323}, 280.9},
                                  {{6.16, 1.1}, {859.8, 10.042}, 543.8},
                                  {{11.85, 1.2}, {906.0, 10.284}, 572.8},
                                  {{11.56, 1.8}, {896.5, 18.368}, 495.6},
                                  {{8.75, 2.1}, {882.6, 17.640}, 507.8},
                                  {{2.91, 0.5}, {832.6, 4.115}, 457.5}}}},
                          OfMap{"env_III",
                                {{{{28.29, 0.8}, {1505.8, 11.980}, 275.7},
                                  {{7.18, 1.5}, {1217.8, 19.966}, 559.0},
                                  {{}, {}, 568.8},
                                  {{}, {}, 472.1},
                                  {{}, {}, 500.9},
                                  {{3.43}, {1160.8}, 456.6}}}},
                          OfMap{"env_IV",
                                {{{{28.74, 1.2}, {1710.6, 9.800}, 503.5},
                                  {{10.02, 6.0}, {1393.46, 16.400}, 580.2},
                                  {{16.91, 1.0}, {1479.4, 13.500}, 592.1},
                                  {{13.56, 1.6}, {1447.5, 21.246}, 434.6},
                                  {{11.82, 0.8}, {1403.9, 19.445}, 550.2},
                                  {{5.67, 0.5}, {1330.2, 7.083}, 510.9}}}}}) {
    const auto add = [&](std::string_view planner, const OfAlgorithm& printed) {
      rows.push_back({"000 Table 8",
                      fmt::format("{} {}", on.map, planner),
                      on.map,
                      planner,
                      {},
                      GridObjective::kLength,
                      {of(Quantity::kRepeatRate, printed.repeat_rate),
                       of(Quantity::kSteps, printed.steps),
                       {Quantity::kConvergence, printed.convergence}}});
    };
    for (std::size_t i = 0; i < kAlgorithms.size(); ++i) add(kAlgorithms[i], on.algorithms[i]);
    add("grid_local_search", {});
  }
}

void add_tractor_rows(std::vector<PaperRow>& rows) {
  struct OfTractor {
    Two repeat_rate;
    Two steps;
    Two fitness;
  };
  constexpr std::array<OfTractor, 6> kPrinted = {
      {{{17.65, 2.9}, {302.5, 6.771}, {3.777e-3, 7.225e-5}},
       {{5.79, 1.3}, {267.7, 3.389}, {3.951e-3, 7.323e-5}},
       {{7.18, 1.5}, {273.8, 3.833}, {3.876e-3, 6.854e-5}},
       {{21.44, 4.9}, {288.3, 10.183}, {4.070e-3, 1.986e-5}},
       {{15.22, 3.1}, {293.9, 8.813}, {4.135e-3, 8.124e-5}},
       {{4.74, 0.9}, {265.9, 2.382}, {4.155e-3, 3.091e-5}}}};
  for (std::size_t i = 0; i < kAlgorithms.size(); ++i) {
    const OfTractor& printed = kPrinted[i];
    rows.push_back(
        {"000 Table 9",
         std::string(kAlgorithms[i]),
         "tractor",
         kAlgorithms[i],
         {},
         GridObjective::kTractor,
         {of(Quantity::kRepeatRate, printed.repeat_rate), of(Quantity::kSteps, printed.steps),
          of(Quantity::kFitness, printed.fitness)}});
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
  for (const OfField& field : {OfField{"field_A", {0, 22, 0}, {0, 22, 0}, 0.22727, 0.16393},
                               OfField{"field_B", {32, 32, 1}, {4, 47, 0}, 0.18519, 0.12048},
                               OfField{"field_C", {16, 26, 4}, {16, 22, 4}, 0.26316, 0.15625},
                               OfField{"field_D", {36, 34, 5}, {12, 42, 3}, 0.11364, 0.09804}}) {
    const auto table_row = [&](std::string_view planner, const std::array<double, 3>& printed) {
      rows.push_back({"001 Table 1",
                      fmt::format("{} {}", field.map, planner),
                      field.map,
                      planner,
                      {},
                      GridObjective::kWeighted,
                      {{Quantity::kRepeats_m2, printed[0]},
                       {Quantity::kTurns, printed[1]},
                       {Quantity::kUTurns, printed[2]}}});
    };
    table_row("grid_boustrophedon", field.by_rows);
    table_row("grid_iga", field.by_iga);
    for (const auto& [points, printed] :
         {std::pair{"multi", field.multi}, std::pair{"single", field.single}}) {
      rows.push_back({"001 Figure 15",
                      fmt::format("{} {}", field.map, points),
                      field.map,
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
       "ants see cells within 3 steps only, and greedy orders end in a given corner; by the "
       "paper's "
       "Eq 11 its Crr do not follow from its lengths, ours do"},
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
       "does; environment III's rows repeat II's in the paper and are left out; CCPP-TPLP's "
       "printed Crr "
       "follows Eq 11 on I and II only: (length - K + 1) / K is 2.45 % on III and 2.01 % on IV"},
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
