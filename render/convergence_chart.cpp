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

// Evenly along the logarithm of x from 1 on.
std::vector<Sample> samples_of(const ConvergenceLine& line, const Axis& axis, double chart_end) {
  const double end = took_no_search(line) ? chart_end : std::max(1.0, end_of(line, axis));
  std::vector<Sample> samples;
  for (int i = 0; i <= kSamplesPerLine; ++i) {
    const double x = std::pow(end, static_cast<double>(i) / kSamplesPerLine);
    if (const auto band = band_at(line, axis, x)) samples.push_back({x, *band});
  }
  return samples;
}

std::string panel_of(const std::vector<ConvergenceLine>& lines, const Axis& axis, bool keyed) {
  double end = 2.0;
  for (const ConvergenceLine& line : lines) end = std::max(end, end_of(line, axis));
  std::string text;
  std::string bands;
  std::string means;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<Sample> samples = samples_of(lines[i], axis, end);
    if (samples.empty()) continue;
    text += fmt::format("${}{} << EOD\n", axis.name, i);
    for (const auto& [x, band] : samples) {
      text += fmt::format("{:.6g} {:.8g} {:.8g} {:.8g}\n", x, band.low, band.mean, band.high);
      least = std::min(least, band.low);
      most = std::max(most, band.high);
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
  const bool logarithmic = least > 0.0 && most / least > kLinearUpTo;
  return text + fmt::format("set xlabel '{}'\nset xrange [1:{:.6g}]\n{} logscale y\nplot {}{}\n",
                            axis.label, end, logarithmic ? "set" : "unset", bands,
                            means.substr(0, means.size() - 2));
}

}  // namespace

std::string convergence_chart_script(const std::string& title,
                                     const std::vector<ConvergenceLine>& lines) {
  return fmt::format("set multiplot title {} font 'DejaVu Sans Bold,14'\n", gnuplot_text(title)) +
         "set grid ytics lt 1 lw 1 lc rgb '#d8d8d8'\nset border 3\nset tics nomirror\n"
         "set logscale x\nset format x '10^{%L}'\nset xtics enhanced\n"
         "set ylabel 'cost of the best plan so far'\n"
         "set lmargin at screen 0.07\nset rmargin at screen 0.40\nset bmargin at screen 0.13\n"
         "set tmargin at screen 0.90\nunset key\n" +
         panel_of(lines, kIterations, false) +
         "unset ylabel\nset lmargin at screen 0.46\nset rmargin at screen 0.79\n"
         "set key at screen 0.81, screen 0.88 left top Left reverse vertical maxrows 20\n" +
         panel_of(lines, kEvaluations, true) + "unset multiplot\n";
}

}  // namespace headland
