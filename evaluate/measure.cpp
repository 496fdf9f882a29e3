#include "evaluate/measure.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>

#include "sim/ledger.h"
#include "sim/simulation.h"
#include "terrains/input_error.h"
#include "terrains/micro_relief.h"
#include "terrains/soil_map.h"
#include "vehicle_models/vehicle_figures.h"

namespace headland {
namespace {

constexpr double kAround_m = 15.0;  // ground beyond the courses
constexpr double kFinestCell_m = 0.25;
constexpr std::size_t kMostNodes = 100'000'000;  // of the ground: 0.8 GB, once more a job
constexpr double kRecord_hz = 1.0;               // nothing but the totals of segments is used

// What one repeat took in its window.
struct Window {
  Outcome outcome = Outcome::kFinished;
  std::string outcome_detail;
  EnergyBalance energy;
  double time_s = 0.0;
  double distance_m = 0.0;
  double slip_sum_m = 0.0;
  double scuffed_m2 = 0.0;
  double peak_power_w = 0.0;
};

struct Ground {
  Field field;
  Heightfield level;
};

Ground make_ground(const std::vector<Course>& courses, const MeasureOptions& options) {
  Eigen::AlignedBox2d box;
  for (const Course& course : courses) {
    for (const PathSegment& segment : course.path.segments) {
      for (const PathPoint& point : segment.points) box.extend(point.p_W);
    }
  }
  box = {box.min().array() - kAround_m, box.max().array() + kAround_m};
  Ground ground;
  ground.field.name = "measured manoeuvres";
  ground.field.boundary = {
      box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}};
  Heightfield& level = ground.level;
  level.cell_m = std::min(kFinestCell_m, options.micro_relief.correlation_m / kCellsPerCorrelation);
  level.origin_W = box.min().array() - level.cell_m;
  level.columns = static_cast<int>(std::ceil(box.sizes().x() / level.cell_m)) + 3;
  level.rows = static_cast<int>(std::ceil(box.sizes().y() / level.cell_m)) + 3;
  const auto nodes = static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows);
  if (nodes > kMostNodes) {
    throw InputError(
        "--relief-length", "", fmt::format("{:g}", options.micro_relief.correlation_m),
        fmt::format("the relief of these manoeuvres would have {:.0f} million heights, "
                    "at most {:.0f}; a greater length, or smaller --row-spacing",
                    1e-6 * static_cast<double>(nodes), 1e-6 * kMostNodes));
  }
  level.height_m.assign(nodes, 0.0);
  return ground;
}

Heightfield tilted(Heightfield terrain, double slope_x, double slope_y) {
  for (int j = 0; j < terrain.rows; ++j) {
    for (int i = 0; i < terrain.columns; ++i) {
      const Eigen::Vector2d p_W = terrain.origin_W + terrain.cell_m * Eigen::Vector2d(i, j);
      terrain.height_m[static_cast<std::size_t>(j) * static_cast<std::size_t>(terrain.columns) +
                       static_cast<std::size_t>(i)] += slope_x * p_W.x() + slope_y * p_W.y();
    }
  }
  return terrain;
}

// Slows the driver of a straight down to the speed that is asked for; other manoeuvres are driven
// as the driver would.
Vehicle at_speed(Vehicle vehicle, const Manoeuvre& manoeuvre) {
  vehicle.driver.work_speed_mps = manoeuvre.speed_mps;
  if (manoeuvre.kind <= ManoeuvreKind::kImplementCycle || !manoeuvre.implement_down) {
    vehicle.driver.transit_speed_mps = manoeuvre.speed_mps;
  }
  return vehicle;
}

Window drive_window(const Manoeuvre& manoeuvre, const Course& course, const Vehicle& given,
                    const SoilMap& soil, const Field& field, const Heightfield& relief,
                    double rate_hz) {
  const Vehicle vehicle = at_speed(given, manoeuvre);
  const Heightfield terrain = tilted(relief, manoeuvre.slope_along, manoeuvre.slope_across);
  SimulationOptions options;
  options.rate_hz = rate_hz;
  options.record_hz = kRecord_hz;
  const RunRecord run = simulate({field, terrain, soil, vehicle, course.path, options, nullptr});
  Window window;
  window.outcome = run.outcome;
  window.outcome_detail = run.outcome_detail;
  for (const SegmentRecord& segment : run.segments) {
    if (segment.segment < course.first_segment || segment.segment > course.last_segment) continue;
    add(window.energy, segment.energy);
    window.time_s += segment.duration_s;
    window.distance_m += segment.distance_m;
    window.slip_sum_m += segment.slip_sum_m;
    window.scuffed_m2 += segment.scuffed_m2;
    window.peak_power_w = std::max(window.peak_power_w, segment.peak_power_w);
  }
  return window;
}

// Adds `times` what another window took.
void add_times(Window& sum, const Window& other, double times) {
  sum.energy.battery_j += times * other.energy.battery_j;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    sum.energy.cause_j[i] += times * other.energy.cause_j[i];
  }
  sum.time_s += times * other.time_s;
  sum.distance_m += times * other.distance_m;
  sum.slip_sum_m += times * other.slip_sum_m;
  sum.scuffed_m2 += times * other.scuffed_m2;
}

using Repeats = std::vector<Window>;

template <typename Value>
Estimate over(const Repeats& repeats, Value value) {
  std::vector<double> values;
  for (const Window& window : repeats) values.push_back(value(window));
  return estimate_of(values);
}

// Steady driving on the flat at the work speed, one window a repeat.
struct Baselines {
  const Repeats* down = nullptr;
  const Repeats* raised = nullptr;
};

bool is_baseline(const Manoeuvre& m, const Vehicle& vehicle) {
  return m.kind == ManoeuvreKind::kStraight && m.speed_mps == vehicle.driver.work_speed_mps &&
         m.slope_along == 0.0 && m.slope_across == 0.0;
}

Baselines find_baselines(const std::vector<Manoeuvre>& list, const std::vector<Repeats>& driven,
                         const Vehicle& vehicle) {
  Baselines found;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!is_baseline(list[i], vehicle)) continue;
    (list[i].implement_down ? found.down : found.raised) = &driven[i];
  }
  return found;
}

void require_finished(const Window& baseline, const Vehicle& vehicle, const Soil& soil) {
  if (baseline.outcome == Outcome::kFinished) return;
  throw InputError(
      vehicle.name, "", fmt::format("soil {}", soil.name),
      fmt::format("ground on which the vehicle can work on the flat; {}", baseline.outcome_detail));
}

// What the manoeuvre itself took: the window less steady driving over its straight parts.
Window without_straights(const Window& window, const Course& course, const Baselines& steady,
                         std::size_t repeat) {
  Window cost = window;
  const auto take_off = [&](const Repeats* baseline, double length_m) {
    if (length_m == 0.0) return;
    const Window& straight = (*baseline)[repeat];
    add_times(cost, straight, -length_m / straight.distance_m);
  };
  take_off(steady.down, course.down_m);
  take_off(steady.raised, course.raised_m);
  return cost;
}

MeasuredCost cost_of(const Manoeuvre& manoeuvre, const Course& course, const Repeats& windows,
                     const Baselines& steady) {
  MeasuredCost cost;
  cost.manoeuvre = manoeuvre;
  for (const Window& window : windows) {
    if (window.outcome == Outcome::kFinished) continue;
    cost.outcome = window.outcome;
    cost.outcome_detail = window.outcome_detail;
    return cost;
  }
  Repeats own;
  Repeats marginal;
  const bool straight = manoeuvre.kind == ManoeuvreKind::kStraight;
  const Repeats* beside = straight && manoeuvre.implement_down ? steady.down : steady.raised;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    own.push_back(without_straights(windows[i], course, steady, i));
    marginal.push_back(own.back());
    const Window& baseline = (*beside)[i];
    add_times(marginal.back(), baseline, -own.back().distance_m / baseline.distance_m);
  }
  cost.energy_j = over(own, [](const Window& w) { return w.energy.battery_j; });
  cost.time_s = over(own, [](const Window& w) { return w.time_s; });
  cost.distance_m = over(own, [](const Window& w) { return w.distance_m; });
  cost.slip = over(windows, [](const Window& w) { return w.slip_sum_m / w.distance_m; });
  cost.scuffed_m2 = over(own, [](const Window& w) { return w.scuffed_m2; });
  cost.peak_power_w = over(windows, [](const Window& w) { return w.peak_power_w; });
  cost.marginal_energy_j = over(marginal, [](const Window& w) { return w.energy.battery_j; });
  cost.marginal_time_s = over(marginal, [](const Window& w) { return w.time_s; });
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    cost.cause_j[i] = over(own, [i](const Window& w) { return w.energy.cause_j[i]; }).mean;
  }
  return cost;
}

void add_formula(const FormulaVehicle& formula, const CostTable& table, MeasuredCost& cost) {
  const Manoeuvre& m = cost.manoeuvre;
  if (m.kind == ManoeuvreKind::kStraight) {
    const double flat_m = cost.distance_m.mean;
    cost.formula_j = formula_straight_j(formula, m.slope_along, flat_m);
    cost.formula_as_printed_j = formula_straight_as_printed_j(formula, m.slope_along, flat_m);
  } else if (m.kind >= ManoeuvreKind::kTurn90) {
    // Between rows the paper's tractor turns twice, and drives on by a cell as everywhere else.
    const double turn_j = formula_turn_j(formula, table.working_width_m, table.work_speed_mps);
    const bool once = m.kind == ManoeuvreKind::kTurn90;
    const double on_m = once ? 0.0 : m.row_spacing_m;
    cost.formula_j = (once ? 1.0 : 2.0) * turn_j + formula_straight_j(formula, 0.0, on_m);
    cost.formula_as_printed_j = cost.formula_j;
  }
}

// The baselines, all else: places in `list`.
std::array<std::vector<std::size_t>, 2> in_order(const std::vector<Manoeuvre>& list,
                                                 const Vehicle& vehicle) {
  std::array<std::vector<std::size_t>, 2> order;
  for (std::size_t i = 0; i < list.size(); ++i) {
    order[is_baseline(list[i], vehicle) ? 0 : 1].push_back(i);
  }
  return order;
}

// One repeat after the other: their reliefs together may not fit into memory. Baselines first:
// without them nothing else counts.
std::optional<std::vector<Repeats>> drive_all(const std::vector<Manoeuvre>& list,
                                              const std::vector<Course>& courses,
                                              const Vehicle& vehicle, const Soil& soil,
                                              const MeasureOptions& options) {
  const Ground ground = make_ground(courses, options);
  const SoilMap soil_map = uniform_soil(soil);
  const auto repeats = static_cast<std::size_t>(options.repeats);
  const auto order = in_order(list, vehicle);
  std::vector<Repeats> driven(list.size(), Repeats(repeats));
  std::atomic<bool> stopped = false;
  std::mutex mutex;
  std::size_t done = 0;
  const std::size_t all = list.size() * repeats;
  // More threads than processors only when asked for.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.jobs));
  tbb::task_arena arena(options.jobs);
  for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
    Heightfield relief = ground.level;
    add_micro_relief(options.micro_relief, options.seed + repeat, relief);
    const auto drive_one = [&](std::size_t m) {
      if (stopped) return;
      driven[m][repeat] = drive_window(list[m], courses[m], vehicle, soil_map, ground.field, relief,
                                       options.rate_hz);
      const std::scoped_lock lock(mutex);
      ++done;
      if (options.progress &&
          !options.progress(static_cast<double>(done) / static_cast<double>(all)))
        stopped = true;
    };
    for (const std::vector<std::size_t>& places : order) {
      arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, places.size(),
                          [&](std::size_t i) { drive_one(places[i]); });
      });
      if (stopped) return std::nullopt;
      for (const std::size_t m : order[0]) require_finished(driven[m][repeat], vehicle, soil);
    }
  }
  return driven;
}

}  // namespace

MeasureOptions planning_measurements(int jobs) {
  MeasureOptions options;
  options.repeats = 2;
  options.ranges.speed_shares = {1.0};
  options.jobs = jobs;
  return options;
}

CostTable measure_costs(const Vehicle& vehicle, const Soil& soil, const MeasureOptions& options) {
  CostTable table;
  table.vehicle = vehicle.name;
  table.soil = soil.name;
  table.mass_kg = total_mass_kg(vehicle);
  table.working_width_m = vehicle.implement.working_width_m;
  table.turning_radius_m = planning_turning_radius_m(vehicle);
  table.work_speed_mps = vehicle.driver.work_speed_mps;
  table.rate_hz = options.rate_hz;
  table.micro_relief = options.micro_relief;
  table.seed = options.seed;
  table.repeats = options.repeats;
  table.formula_mu = options.formula_mu;

  const std::vector<Manoeuvre> list = standard_manoeuvres(vehicle, options.ranges);
  std::vector<Course> courses;
  courses.reserve(list.size());
  for (const Manoeuvre& manoeuvre : list) courses.push_back(course_of(manoeuvre, vehicle));
  const auto driven = drive_all(list, courses, vehicle, soil, options);
  if (!driven) return table;

  const Baselines steady = find_baselines(list, *driven, vehicle);
  Window raised;
  for (const Window& window : *steady.raised) add_times(raised, window, 1.0);
  table.formula_turn_power_w = options.formula_turn_power_w > 0.0
                                   ? options.formula_turn_power_w
                                   : raised.energy.battery_j / raised.time_s;
  const FormulaVehicle formula{table.mass_kg, table.formula_mu, table.formula_turn_power_w};
  for (std::size_t i = 0; i < list.size(); ++i) {
    table.costs.push_back(cost_of(list[i], courses[i], (*driven)[i], steady));
    if (table.costs.back().outcome == Outcome::kFinished) {
      add_formula(formula, table, table.costs.back());
    }
  }
  return table;
}

}  // namespace headland
