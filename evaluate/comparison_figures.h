// The figures by which plans are compared, and what they come to over repeats.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/comparison.h"

namespace headland {

// Of what a figure is told.
enum class FigureOf { kAnyPlan, kGridPlan, kRegionPlan, kDrive };

// One row of a literal table, which the tables, the summary and the tests share.
struct ComparedFigure {
  std::string_view key;      // in files, with its unit
  std::string_view heading;  // in the summary's columns
  int decimals = 0;
  double scale = 1.0;  // of the summary's number: 100 for percent
  bool more_is_better = false;
  FigureOf of = FigureOf::kAnyPlan;
  double (*value)(const ComparedRun&);  // NaN where it is not known
};

// Whether the run has this figure: it was planned and, for figures of the drive, driven, and the
// figure is known.
bool has_figure(const ComparedFigure& figure, const ComparedRun& run);

std::span<const ComparedFigure> every_figure();

// Those of a comparison: of maps or of fields, with those of drives when there are any.
std::vector<ComparedFigure> compared_figures(const Comparison& comparison);

// Throws InputError(source, where) with the nearest name.
const ComparedFigure& find_figure(std::string_view key, const std::string& source,
                                  const std::string& where);

// Over the runs of one planner on one map that have the figure.
struct Spread {
  int runs = 0;
  double mean = 0.0;
  double deviation = 0.0;  // of the sample (n - 1); 0 for one run
  double median = 0.0;     // of an even number the mean of the middle two
  double best = 0.0;       // by more_is_better
  double worst = 0.0;
};

// nullopt when none has it.
std::optional<Spread> spread_of(const ComparedFigure& figure,
                                const std::vector<const ComparedRun*>& runs);

// How the runs of one planner on one map ended.
struct RunCounts {
  int asked = 0;
  int planned = 0;
  int refused = 0;
  int not_run = 0;
  int with_jumps = 0;   // of the planned ones
  std::string refusal;  // of the first
};
RunCounts run_counts(const std::vector<const ComparedRun*>& runs);

}  // namespace headland
