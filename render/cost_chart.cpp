#include "render/cost_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "render/gnuplot.h"

namespace headland {
namespace {

// The causes as people sum them up, from the bottom of a bar to its top.
struct CauseGroup {
  const char* name;
  const char* colour;  // Okabe and Ito
  std::vector<EnergyCause> causes;
};

const std::array<CauseGroup, 7>& cause_groups() {
  static const std::array<CauseGroup, 7> groups{{
      {"rolling", "#009e73", {EnergyCause::kRolling, EnergyCause::kSuspension}},
      {"slip and scrub", "#d55e00", {EnergyCause::kSlip, EnergyCause::kScrub}},
      {"draft, shaft, lift", "#0072b2", {EnergyCause::kDraft, EnergyCause::kImplement}},
      {"gear, motor, inverter",
       "#e69f00",
       {EnergyCause::kDrivetrain, EnergyCause::kMotor, EnergyCause::kInverter}},
      {"brakes", "#000000", {EnergyCause::kBrake}},
      {"battery", "#cc79a7", {EnergyCause::kBatteryLoss}},
      {"steering, auxiliaries", "#56b4e9", {EnergyCause::kSteering, EnergyCause::kAuxiliary}},
  }};
  return groups;
}

constexpr std::array kLineColours = {"#0072b2", "#009e73", "#e69f00",
                                     "#d55e00", "#cc79a7", "#56b4e9"};

bool drawn_along(const MeasuredCost& cost) {
  const Manoeuvre& m = cost.manoeuvre;
  return m.kind == ManoeuvreKind::kStraight && m.implement_down && m.slope_across == 0.0 &&
         cost.outcome == Outcome::kFinished;
}

double wh(double energy_j) { return energy_j / kJoulePerWattHour; }

std::string slope_panel(const CostTable& table) {
  std::set<double> speeds_mps;
  for (const MeasuredCost& cost : table.costs) {
    if (drawn_along(cost)) speeds_mps.insert(cost.manoeuvre.speed_mps);
  }
  std::string blocks;
  std::string plots;
  std::size_t line = 0;
  for (const double speed_mps : speeds_mps) {
    blocks += fmt::format("$speed{} << EOD\n", line);
    for (const MeasuredCost& cost : table.costs) {
      if (!drawn_along(cost) || cost.manoeuvre.speed_mps != speed_mps) continue;
      const double per_m = 1.0 / cost.distance_m.mean;
      blocks +=
          fmt::format("{:g} {:g} {:g}\n", 100.0 * cost.manoeuvre.slope_along,
                      wh(cost.energy_j.mean) * per_m, wh(cost.energy_j.ci95.value_or(0.0)) * per_m);
    }
    blocks += "EOD\n";
    plots += fmt::format(
        "$speed{0} using 1:2:3 with yerrorlines lw 2 pt 7 ps 0.6 lc rgb '{1}' title {2}, ", line,
        kLineColours[line % kLineColours.size()],
        gnuplot_text(fmt::format("{:.2f} m/s, implement down", speed_mps)));
    ++line;
  }
  blocks += "$formula << EOD\n";
  for (const MeasuredCost& cost : table.costs) {
    if (!drawn_along(cost) || cost.manoeuvre.speed_mps != table.work_speed_mps) continue;
    blocks += fmt::format("{:g} {:g}\n", 100.0 * cost.manoeuvre.slope_along,
                          wh(cost.formula_j) / cost.distance_m.mean);
  }
  blocks += "EOD\n";
  return blocks +
         "set title 'Energy of a metre straight on'\n"
         "set xlabel 'slope along the drive [%], uphill positive'\n"
         "set ylabel 'Wh/m'\nset key outside right top Left reverse\n"
         "plot " +
         plots +
         fmt::format("$formula using 1:2 with lines lw 2 dt 2 lc rgb '#606060' title {}\n",
                     gnuplot_text(fmt::format("paper 000, mu {:g}", table.formula_mu)));
}

std::string bar_label(const Manoeuvre& m) {
  std::string label(manoeuvre_name(m.kind));
  if (m.row_spacing_m > 0.0) label += fmt::format(" {:.1f} m", m.row_spacing_m);
  if (m.kind < ManoeuvreKind::kUTurn) label += m.implement_down ? ", down" : ", raised";
  return label;
}

std::string turn_panel(const CostTable& table) {
  std::string block = "$turns << EOD\n";
  for (const MeasuredCost& cost : table.costs) {
    if (cost.manoeuvre.kind == ManoeuvreKind::kStraight || cost.outcome != Outcome::kFinished)
      continue;
    block += fmt::format("\"{}\"", bar_label(cost.manoeuvre));
    for (const CauseGroup& group : cause_groups()) {
      double sum_j = 0.0;
      for (const EnergyCause cause : group.causes) {
        sum_j += cost.cause_j[static_cast<std::size_t>(cause)];
      }
      block += fmt::format(" {:g}", wh(sum_j));
    }
    block += "\n";
  }
  block += "EOD\n";
  std::string plots;
  for (std::size_t i = 0; i < cause_groups().size(); ++i) {
    const CauseGroup& group = cause_groups()[i];
    plots += fmt::format("{}$turns using {}{} lc rgb '{}' title '{}'", i == 0 ? "" : ", ", i + 2,
                         i == 0 ? ":xtic(1)" : "", group.colour, group.name);
  }
  return block +
         "set title 'Energy of a manoeuvre, beyond the straights before and after it'\n"
         "unset xlabel\nset ylabel 'Wh'\n"
         "set style data histograms\nset style histogram rowstacked\n"
         "set style fill solid 0.9 noborder\nset boxwidth 0.7\n"
         "set xtics rotate by -35 left\nset xzeroaxis lt -1\n"
         "plot " +
         plots + "\n";
}

}  // namespace

std::string cost_chart_script(const CostTable& table) {
  return fmt::format("set multiplot layout 2,1 title {} font 'DejaVu Sans Bold,14'\n",
                     gnuplot_text(fmt::format("What driving costs: {} on {} ground", table.vehicle,
                                              table.soil))) +
         "set grid ytics lt 1 lw 1 lc rgb '#d8d8d8'\nset border 3\nset tics nomirror\n"
         "set rmargin 34\n" +
         slope_panel(table) + turn_panel(table) + "unset multiplot\n";
}

}  // namespace headland
