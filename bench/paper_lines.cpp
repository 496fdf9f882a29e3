#include "bench/paper_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace headland::bench {
namespace {

// Of a sample; 0 of a single value.
double deviation(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean(values)) * (value - mean(values));
  return std::sqrt(squares / (static_cast<double>(values.size()) - 1.0));
}

double best(const Line& line) {
  const bool most = line.quantity == Quantity::kFitness || line.more_is_better;
  return most ? *std::ranges::max_element(line.values) : *std::ranges::min_element(line.values);
}

std::string_view unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::kSteps:
      return "steps";
    case Quantity::kRepeatRate:
      return "Crr %";
    case Quantity::kConvergence:
      return "found in";
    case Quantity::kFitness:
      return "fitness";
    case Quantity::kRepeats_m2:
      return "m2 again";
    case Quantity::kTurns:
      return "turns";
    case Quantity::kUTurns:
      break;
  }
  return "U-turns";
}

bool is_printed(const Line& line) { return std::isfinite(line.printed_mean); }

}  // namespace

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void print_line(const Line& line) {
  std::string printed = is_printed(line) ? fmt::format("{:.6g}", line.printed_mean) : "-";
  if (line.printed_deviation >= 0.0) printed += fmt::format(" +- {:.3g}", line.printed_deviation);
  fmt::print("  {:<30} {:<8} {:>10.5g} +- {:<9.3g} best {:<9.5g} {:>8.3f} s   printed {}\n",
             line.name, unit_of(line.quantity), mean(line.values), deviation(line.values),
             best(line), line.seconds, printed);
}

nlohmann::ordered_json json_of(const Line& line, std::string_view why) {
  nlohmann::ordered_json json = {{"table", line.table},
                                 {"name", line.name},
                                 {"unit", unit_of(line.quantity)},
                                 {"runs", line.values.size()},
                                 {"mean", mean(line.values)},
                                 {"deviation", deviation(line.values)},
                                 {"best", best(line)},
                                 {"processor_s", line.seconds}};
  json["printed_mean"] = is_printed(line) ? nlohmann::ordered_json(line.printed_mean) : nullptr;
  json["printed_deviation"] =
      line.printed_deviation >= 0.0 ? nlohmann::ordered_json(line.printed_deviation) : nullptr;
  json["why_they_differ"] = why;
  return json;
}

std::vector<Line> averages(const std::vector<Line>& lines) {
  std::vector<Line> all;
  std::vector<double> counts;
  for (const Line& line : lines) {
    const std::string name = "average" + line.name.substr(line.name.find(' '));
    const auto found = std::ranges::find_if(all, [&](const Line& average) {
      return average.name == name && average.quantity == line.quantity;
    });
    if (found == all.end()) {
      all.push_back(line);
      all.back().name = name;
      all.back().printed_deviation = -1.0;
      counts.push_back(1.0);
      continue;
    }
    counts[static_cast<std::size_t>(found - all.begin())] += 1.0;
    for (std::size_t i = 0; i < line.values.size(); ++i) found->values[i] += line.values[i];
    found->seconds += line.seconds;
    found->printed_mean += line.printed_mean;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (double& value : all[i].values) value /= counts[i];
    all[i].seconds /= counts[i];
    all[i].printed_mean /= counts[i];
  }
  return all;
}

}  // namespace headland::bench
