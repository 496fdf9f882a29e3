// headland measure: what straights, slopes and turns cost a vehicle on a soil.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/progress.h"
#include "apps/terminal_text.h"
#include "evaluate/atomic_file.h"
#include "evaluate/measure.h"
#include "render/cost_chart.h"
#include "render/gnuplot.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

struct MeasureCommand {
  std::string vehicle;
  std::string soil = "firm";
  std::string folder;
  MeasureOptions options;
  bool quiet = false;
};

constexpr const char* kFiles[] = {"costs.yaml", "costs.csv", "costs.svg", "costs.png"};

void check_numbers(const MeasureOptions& options) {
  const auto check = [](const char* option, double value, double min, double max) {
    if (value >= min && value <= max) return;
    throw InputError(option, "", fmt::format("{:g}", value),
                     fmt::format("a number from {:g} to {:g}", min, max));
  };
  check("--repeats", options.repeats, 1, 1000);
  check("--jobs", options.jobs, 1, 1024);
  check("--relief-rms", options.micro_relief.rms_m, 0.0, kMaxRoughness_m);
  check("--relief-length", options.micro_relief.correlation_m, kMinCorrelation_m,
        kMaxCorrelation_m);
  check("--rate-hz", options.rate_hz, 60.0, 1000.0);
  check("--formula-mu", options.formula_mu, 0.0, 2.0);
  check("--formula-turn-power", options.formula_turn_power_w, 0.0, 1e6);
  for (const double spacing_m : options.ranges.spacings_m) {
    check("--row-spacing", spacing_m, 0.1, 100.0);
  }
}

std::string with_interval(const Estimate& estimate, double scale, int decimals) {
  if (!estimate.ci95) return fmt::format("{:.{}f}", scale * estimate.mean, decimals);
  return fmt::format("{:.{}f} ±{:.{}f}", scale * estimate.mean, decimals, scale * *estimate.ci95,
                     decimals);
}

std::string ratio_text(double measured, double formula) {
  return formula > 0.0 ? fmt::format("{:.2f}", measured / formula) : "";
}

std::string straights_table(const CostTable& table) {
  std::string text =
      fmt::format("\n  {:<10}{:>9}{:>9}{:>9}{:>19}{:>8}{:>9}{:>10}{:>9}\n", "straight", "m/s",
                  "along %", "across %", "Wh/m", "slip %", "peak kW", "formula", "ratio");
  for (const MeasuredCost& cost : table.costs) {
    const Manoeuvre& m = cost.manoeuvre;
    if (m.kind != ManoeuvreKind::kStraight) continue;
    text += fmt::format("  {:<10}{:>9.2f}{:>9.0f}{:>9.0f}", m.implement_down ? "down" : "raised",
                        m.speed_mps, 100.0 * m.slope_along, 100.0 * m.slope_across);
    if (cost.outcome != Outcome::kFinished) {
      text += fmt::format("   {}\n", cost.outcome_detail);
      continue;
    }
    const double per_m = 1.0 / (kJoulePerWattHour * cost.distance_m.mean);
    text += fmt::format("{:>20}{:>8.1f}{:>9.2f}{:>10.4f}{:>9}\n",
                        with_interval(cost.energy_j, per_m, 4), 100.0 * cost.slip.mean,
                        1e-3 * cost.peak_power_w.mean, per_m * cost.formula_j,
                        ratio_text(cost.energy_j.mean, cost.formula_j));
  }
  return text;
}

std::string manoeuvres_table(const CostTable& table) {
  constexpr double kPerWh = 1.0 / kJoulePerWattHour;
  std::string text = fmt::format("\n  {:<18}{:<8}{:>9}{:>17}{:>17}{:>15}{:>8}{:>10}{:>10}{:>7}\n",
                                 "manoeuvre", "", "rows [m]", "Wh", "Wh beyond*", "time [s]",
                                 "way [m]", "scuff m2", "formula", "ratio");
  for (const MeasuredCost& cost : table.costs) {
    const Manoeuvre& m = cost.manoeuvre;
    if (m.kind == ManoeuvreKind::kStraight) continue;
    text +=
        fmt::format("  {:<18}{:<8}{:>9}", manoeuvre_name(m.kind),
                    m.kind >= ManoeuvreKind::kUTurn || m.kind == ManoeuvreKind::kImplementCycle ? ""
                    : m.implement_down ? "down"
                                       : "raised",
                    m.row_spacing_m > 0.0 ? fmt::format("{:.2f}", m.row_spacing_m) : "");
    if (cost.outcome != Outcome::kFinished) {
      text += fmt::format("   {}\n", cost.outcome_detail);
      continue;
    }
    text += fmt::format(
        "{:>18}{:>18}{:>16}{:>8.1f}{:>10.2f}{:>10}{:>7}\n", with_interval(cost.energy_j, kPerWh, 3),
        with_interval(cost.marginal_energy_j, kPerWh, 3), with_interval(cost.time_s, 1.0, 1),
        cost.distance_m.mean, cost.scuffed_m2.mean,
        cost.formula_j > 0.0 ? fmt::format("{:.3f}", kPerWh * cost.formula_j) : "",
        ratio_text(cost.energy_j.mean, cost.formula_j));
  }
  return text + "  * beyond straight driving over the same distance with the implement raised\n";
}

std::string cost_summary(const CostTable& table) {
  return fmt::format(
             "{} on {} ground, {:.0f} kg, {:g} m, turns of {:.2f} m radius, micro-relief "
             "{:g} m rms, {} repeats, seed {}\n",
             table.vehicle, table.soil, table.mass_kg, table.working_width_m,
             table.turning_radius_m, table.micro_relief.rms_m, table.repeats, table.seed) +
         straights_table(table) + manoeuvres_table(table);
}

int measure(MeasureCommand& command) {
  MeasureOptions& options = command.options;
  check_numbers(options);
  check_output_folder(command.folder);
  for (const char* name : kFiles) require_replaceable(std::filesystem::path(command.folder) / name);
  const Soil& soil = soil_named(command.soil, "--soil", "");
  const Vehicle vehicle = load_vehicle(command.vehicle);
  require_gnuplot();
  ProgressLine line = start_progress(command.quiet);
  options.progress = [&line](double done) {
    show_share(line, "measuring", done);
    return !interrupted();
  };
  const CostTable table = measure_costs(vehicle, soil, options);
  end_progress(line);
  stop_if_interrupted();
  const std::string script = cost_chart_script(table);
  write_together(
      command.folder,
      {{kFiles[0], cost_table_yaml(table)},
       {kFiles[1], cost_table_csv(table)},
       {kFiles[2], chart_of(script, ChartFormat::kSvg, kCostChartWidth_px, kCostChartHeight_px)},
       {kFiles[3], chart_of(script, ChartFormat::kPng, kCostChartWidth_px, kCostChartHeight_px)}});
  if (!command.quiet) {
    fmt::print("{}\ntable and chart are in {}\n", cost_summary(table),
               terminal_text(command.folder));
  }
  return kExitRan;
}

}  // namespace

void add_measure_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("measure", "Measure what straights, slopes and turns cost a vehicle");
  auto given = std::make_shared<MeasureCommand>();
  MeasureOptions& options = given->options;
  options.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command->add_option("--vehicle", given->vehicle, "Name of a built-in vehicle, or its folder")
      ->required();
  command->add_option("--soil", given->soil, "Soil (headland list soils)")->capture_default_str();
  command->add_option("-o,--output", given->folder, "Folder for the table and the chart")
      ->required();
  command
      ->add_option("--repeats", options.repeats, "Drives of each manoeuvre, each over other relief")
      ->capture_default_str();
  command->add_option("--seed", options.seed, "Seed of the micro-relief")
      ->capture_default_str()
      ->check(whole_number_fault);
  command
      ->add_option("--relief-rms", options.micro_relief.rms_m,
                   "Height of the micro-relief, rms [m]")
      ->capture_default_str();
  command
      ->add_option("--relief-length", options.micro_relief.correlation_m,
                   "Correlation length of the micro-relief [m]")
      ->capture_default_str();
  command->add_option("--row-spacing", options.ranges.spacings_m,
                      "Distances between rows to turn over [m] (default: 1, 2, 3 working widths "
                      "and turning radii)");
  command->add_option("--rate-hz", options.rate_hz, "Steps a second")->capture_default_str();
  command->add_option("--formula-mu", options.formula_mu, "Friction in the formula of paper 000")
      ->capture_default_str();
  command->add_option("--formula-turn-power", options.formula_turn_power_w,
                      "U times I in turns in that formula [W] (default: as measured straight on)");
  command->add_option("--jobs", options.jobs, "Drives at the same time")->capture_default_str();
  command->add_flag("--quiet,-q", given->quiet, "No progress and no summary");
  command->footer(
      "Examples:\n  headland measure --vehicle transplanter --soil firm -o out/costs\n"
      "  headland measure --vehicle horticultural_tractor --soil tilled "
      "--formula-turn-power 2310 -o out/costs\n\n"
      "Writes costs.yaml (for planners), costs.csv and the chart costs.svg, costs.png.");
  command->callback([given, &exit_code] { exit_code = measure(*given); });
}

}  // namespace headland
