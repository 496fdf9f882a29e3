#include "render/convergence_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "render/gnuplot.h"

namespace headland {
namespace {

// Okabe and Ito, black last.
constexpr std::array kLineColour = {"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                    "#e69f00", "#56b4e9", "#8c6d1f", "#000000"};
constexpr int kSamplesPerLine = 240;
// Costs that differ by more than this factor are told apart on a logarithmic scale only.
constexpr double kLinearUpTo = 3.0;
constexpr double kAir = 1.1;  // above and below what is drawn, as a factor

// What the search is followed along: iterations or evaluations.
struct Axis {
  const char* name;
  const char* label;
  double (*of_point)(const ConvergencePoint&);
  double (*end)(const ConvergenceLine&, std::size_t run);
};

constexpr Axis kIterations{
    "iterations", "iterations",
    [](const ConvergencePoint& point) { return static_cast<double>(point.iteration); },
    [](const ConvergenceLine& line, std::size_t run) {
      return static_cast<double>(line.iterations[run]);
    }};
constexpr Axis kEvaluations{
    "evaluations", "evaluations",
    [](const ConvergencePoint& point) { return static_cast<double>(point.evaluations); },
    [](const ConvergenceLine& line, std::size_t run) {
      return static_cast<double>(line.evaluations[run]);
    }};

struct Band {
  double low = 0.0;
  double mean = 0.0;
  double high = 0.0;
};

bool took_no_search(const ConvergenceLine& line) {
  return std::all_of(line.iterations.begin(), line.iterations.end(),
                     [](int iterations) { return iterations == 0; });
}

// Over the runs at `x`; nullopt before the last of them has a plan.
std::optional<Band> band_at(const ConvergenceLine& line, const Axis& axis, double x) {
  std::vector<double> costs;
  for (const std::vector<ConvergencePoint>& run : line.runs) {
    std::optional<double> cost;
    for (const ConvergencePoint& point : run) {
      if (axis.of_point(point) <= x) cost = point.cost;
    }
    if (!cost) return std::nullopt;
    costs.push_back(*cost);
  }
  if (costs.empty()) return std::nullopt;
  Band band;
  const auto n = static_cast<double>(costs.size());
  for (const double cost : costs) band.mean += cost / n;
  double squares = 0.0;
  for (const double cost : costs) squares += (cost - band.mean) * (cost - band.mean);
  const double deviation = n > 1.0 ? std::sqrt(squares / (n - 1.0)) : 0.0;
  const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
  // Not beyond what any run had: a band below 0 has no place on a logarithmic scale.
  band.low = std::max(*least, band.mean - deviation);
  band.high = std::min(*most, band.mean + deviation);
  return band;
}

double end_of(const ConvergenceLine& line, const Axis& axis) {
  double end = 0.0;
  for (std::size_t run = 0; run < line.runs.size(); ++run) end = std::max(end, axis.end(line, run));
  return end;
}

struct Sample {
  double x = 0.0;
  Band band;
};

struct Range {
  double low = 1.0;
  double high = 2.0;
};

// From the first plan that a search found to the end of the longest search.
Range range_of(const std::vector<ConvergenceLine>& lines, const Axis& axis) {
  Range range;
  double first = std::numeric_limits<double>::infinity();
  for (const ConvergenceLine& line : lines) {
    range.high = std::max(range.high, end_of(line, axis));
    if (took_no_search(line)) continue;
    for (const std::vector<ConvergencePoint>& run : line.runs) {
      if (!run.empty()) first = std::min(first, axis.of_point(run.front()));
    }
  }
  if (first < range.high) range.low = std::max(range.low, first);
  return range;
}

// Evenly along the logarithm of x.
std::vector<Sample> samples_of(const ConvergenceLine& line, const Axis& axis, const Range& range) {
  const double end = took_no_search(line) ? range.high : std::max(range.low, end_of(line, axis));
  std::vector<Sample> samples;
  for (int i = 0; i <= kSamplesPerLine; ++i) {
    const double x =
        range.low * std::pow(end / range.low, static_cast<double>(i) / kSamplesPerLine);
    if (const auto band = band_at(line, axis, x)) samples.push_back({x, *band});
  }
  return samples;
}

// What all costs lie in; no band reaches further.
Range costs_of(const std::vector<ConvergenceLine>& lines) {
  Range range{std::numeric_limits<double>::infinity(), 0.0};
  for (const ConvergenceLine& line : lines) {
    for (const std::vector<ConvergencePoint>& run : line.runs) {
      for (const ConvergencePoint& point : run) {
        range.low = std::min(range.low, point.cost);
        range.high = std::max(range.high, point.cost);
      }
    }
  }
  return range;
}

// Range and marks of the axis of costs. A logarithmic one is marked at 1, 2 and 5 times powers of
// ten: by itself it would be marked at those powers alone, of which there may be none.
std::string cost_axis(const Range& costs) {
  if (!(costs.low > 0.0 && costs.high / costs.low > kLinearUpTo)) {
    // gnuplot draws no empty range, and takes ends that agree in eight digits for one.
    const double air = 0.05 * (costs.high - costs.low) + 1e-3 * std::max(1.0, std::abs(costs.high));
    return fmt::format("set yrange [{:.8g}:{:.8g}]\n", costs.low - air, costs.high + air);
  }
  const Range range{costs.low / kAir, costs.high * kAir};
  std::string marks;
  for (double power = std::pow(10.0, std::floor(std::log10(range.low))); power <= range.high;
       power *= 10.0) {
    for (const double mark : {power, 2.0 * power, 5.0 * power}) {
      if (mark < range.low || mark > range.high) continue;
      marks += fmt::format("{}{:g}", marks.empty() ? "" : ", ", mark);
    }
  }
  return fmt::format("set logscale y\nset yrange [{:.8g}:{:.8g}]\nset ytics ({})\n", range.low,
                     range.high, marks);
}

std::string panel_of(const std::vector<ConvergenceLine>& lines, const Axis& axis, bool keyed) {
  const Range range = range_of(lines, axis);
  std::string text;
  std::string bands;
  std::string means;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<Sample> samples = samples_of(lines[i], axis, range);
    if (samples.empty()) continue;
    text += fmt::format("${}{} << EOD\n", axis.name, i);
    for (const auto& [x, band] : samples) {
      text += fmt::format("{:.6g} {:.8g} {:.8g} {:.8g}\n", x, band.low, band.mean, band.high);
    }
    text += "EOD\n";
    const char* colour = kLineColour[i % kLineColour.size()];
    const bool dashed = took_no_search(lines[i]) || i >= kLineColour.size();
    bands += fmt::format(
        "${}{} using 1:2:4 with filledcurves fs transparent solid 0.18 noborder "
        "lc rgb '{}' notitle, ",
        axis.name, i, colour);
    means += fmt::format("${}{} using 1:3 with lines lw 2.2 dt {} lc rgb '{}' {}, ", axis.name, i,
                         dashed ? 2 : 1, colour,
                         keyed ? "title " + gnuplot_text(lines[i].label) : "notitle");
  }
  if (means.empty()) return "";
  return text + fmt::format("set xlabel '{}'\nset xrange [{:.6g}:{:.6g}]\nplot {}{}\n", axis.label,
                            range.low, range.high, bands, means.substr(0, means.size() - 2));
}

// Share of the chart's width that the names of the lines take.
double key_share(const std::vector<ConvergenceLine>& lines) {
  constexpr double kSample_px = 84.0;
  constexpr double kLetter_px = 8.0;
  constexpr double kMost = 0.4;
  std::size_t longest = 0;
  for (const ConvergenceLine& line : lines) longest = std::max(longest, line.label.size());
  return std::min(
      kMost, (kSample_px + kLetter_px * static_cast<double>(longest)) / kConvergenceChartWidth_px);
}

}  // namespace

std::string convergence_chart_script(const std::string& title,
                                     const std::vector<ConvergenceLine>& lines) {
  constexpr double kLeft = 0.07;
  constexpr double kGap = 0.06;
  const double key = key_share(lines);
  const double panel = 0.5 * (1.0 - kLeft - kGap - key);
  return fmt::format("set multiplot title {} font 'DejaVu Sans Bold,14'\n",
                     gnuplot_text(title + ": mean of the runs, with one standard deviation")) +
         "set grid ytics lt 1 lw 1 lc rgb '#d8d8d8'\nset border 3\nset tics nomirror\n"
         "set logscale x\nset format x '%.0s%c'\n"
         "set ylabel 'cost of the best plan so far'\nset bmargin at screen 0.13\n"
         "set tmargin at screen 0.90\nunset key\n" +
         cost_axis(costs_of(lines)) +
         fmt::format("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", kLeft,
                     kLeft + panel) +
         panel_of(lines, kIterations, false) +
         fmt::format(
             "unset ylabel\nset lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
             "set key at screen {:.4f}, screen 0.90 left top Left reverse vertical "
             "maxrows 24\n",
             kLeft + panel + kGap, kLeft + 2.0 * panel + kGap, 1.0 - key + 0.015) +
         panel_of(lines, kEvaluations, true) + "unset multiplot\n";
}

}  // namespace headland
