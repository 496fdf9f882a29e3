#include "bench/field_suite_run.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <mutex>

#include "bench/field_suite_rows.h"
#include "bench/figures.h"
#include "evaluate/parallel_runs.h"
#include "planner/drivable_path.h"
#include "terrains/input_error.h"

namespace headland::bench {
namespace {

bool faulty(const SuiteRow& row) { return row.states_outside + row.other_faults > 0; }

bool reached(const SuiteRow& row) {
  return row.refusal.empty() && !faulty(row) && covered_percent(row) >= kWantedPercent;
}

void print_row(const SuiteRow& row) {
  const std::string text =
      fmt::format("{:<8} {:>4} {:>8.2f} {:>2} {:<16}", field_shape_name(row.recipe.shape),
                  row.recipe.seed, 1e-4 * row.recipe.area_m2, row.recipe.holes, row.vehicle);
  if (!row.refusal.empty()) {
    std::puts((text + " refused: " + row.refusal).c_str());
  } else {
    const double largest_m2 = row.missed.empty() ? 0.0 : row.missed.front().area_m2;
    std::puts(
        fmt::format("{} {:>5} {:>8.3f} {:>8.2f} {:>7.2f} {:>7.2f} {:>5} {:>5} {:>5} {:>8.1f} "
                    "{:>6.2f} {:>6.2f} {:>7.2f}",
                    text, row.passes, covered_percent(row), 100.0 * row.reachable_m2 / row.field_m2,
                    100.0 * row.overlap_m2 / row.field_m2, 100.0 * row.outside_m2 / row.field_m2,
                    row.states_outside, row.other_faults, row.missed.size(), largest_m2, row.plan_s,
                    row.path_s, row.audit_s)
            .c_str());
  }
  std::fflush(stdout);
}

void print_totals(const std::string& vehicle, const std::vector<SuiteRow>& rows) {
  int planned = 0;
  int refused = 0;
  int outside = 0;
  int below = 0;
  double reachable_m2 = 0;
  double missed_m2 = 0;
  double field_m2 = 0;
  double overlap_m2 = 0;
  double worst = 100.0;
  for (const SuiteRow& row : rows) {
    if (row.vehicle != vehicle) continue;
    if (!row.refusal.empty()) {
      ++refused;
      continue;
    }
    ++planned;
    outside += faulty(row) ? 1 : 0;
    below += covered_percent(row) < kWantedPercent ? 1 : 0;
    worst = std::min(worst, covered_percent(row));
    reachable_m2 += row.reachable_m2;
    missed_m2 += row.missed_m2;
    field_m2 += row.field_m2;
    overlap_m2 += row.overlap_m2;
  }
  std::puts(
      fmt::format("{}: planned {}, refused {}, with faults {}, below {} % {}, worst {:.3f} %, "
                  "all together {:.3f} % of reachable, {:.3f} % reachable, overlap {:.2f} %",
                  vehicle, planned, refused, outside, kWantedPercent, below, worst,
                  100.0 * (1.0 - missed_m2 / reachable_m2), 100.0 * reachable_m2 / field_m2,
                  100.0 * overlap_m2 / field_m2)
          .c_str());
}

// Takes over the rows of a file that are asked for; which of them it had, the last one counts.
std::vector<char> read_rows(const SuiteAsked& asked, std::vector<SuiteRow>& rows) {
  std::vector<char> known(rows.size(), 0);
  std::ifstream file(asked.rows_file);
  for (std::string line; std::getline(file, line);) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    // A line cut short by an interruption is made again.
    if (json.is_discarded() || !json.is_object() || json.value("set", asked.set) != asked.set) {
      continue;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (json.value("seed", std::uint64_t{0}) != rows[i].recipe.seed ||
          json.value("vehicle", "") != rows[i].vehicle) {
        continue;
      }
      rows[i] = row_of(json, rows[i].recipe);
      known[i] = asked.again && !reached(rows[i]) ? 0 : 1;
    }
  }
  return known;
}

std::ofstream open_rows(const std::string& name) {
  if (name.empty()) return {};
  bool cut_short = false;
  if (std::ifstream before(name, std::ios::ate); before && before.tellg() > 0) {
    before.seekg(-1, std::ios::end);
    cut_short = before.get() != '\n';
  }
  std::ofstream file(name, std::ios::app);
  if (!file) throw InputError(name, "", "", "a file that can be written");
  if (cut_short) file << '\n';
  return file;
}

std::vector<SuiteRow> rows_to_make(const SuiteAsked& asked) {
  std::vector<SuiteRow> rows;
  for (const FieldRecipe& recipe : field_suite(asked.first + asked.fields)) {
    const double area_ha = 1e-4 * recipe.area_m2;
    if (recipe.seed <= static_cast<std::uint64_t>(asked.first)) continue;
    if (area_ha < asked.least_ha || area_ha > asked.most_ha) continue;
    for (const std::string& vehicle : asked.vehicles) {
      rows.emplace_back();
      rows.back().recipe = recipe;
      rows.back().vehicle = vehicle;
    }
  }
  return rows;
}

}  // namespace

void print_suite(const SuiteAsked& asked) {
  std::vector<SuiteRow> rows = rows_to_make(asked);
  const std::vector<char> known = read_rows(asked, rows);
  std::ofstream file = open_rows(asked.rows_file);
  if (!asked.json) {
    std::puts(
        "shape    seed       ha  h vehicle          passes cov/reach reach/field overlap outside "
        "hull< fault patch  largest plan_s path_s audit_s");
  }
  ParallelOptions options;
  options.jobs = asked.jobs;
  std::mutex mutex;
  run_in_parallel(rows.size(), options, [&](std::size_t i, const CancelAsked&) {
    if (known[i] == 0) {
      rows[i] =
          suite_row(rows[i].recipe, rows[i].vehicle, asked.parameters, PathOptions{}.clearance_m);
    }
    const std::scoped_lock lock(mutex);
    if (file.is_open() && known[i] == 0) {
      nlohmann::ordered_json json = row_json(rows[i]);
      json["set"] = asked.set;
      file << json.dump() << std::endl;  // whole rows, whatever ends the program
      if (!file) throw InputError(asked.rows_file, "", "", "a file that can be written");
    }
    if (!asked.json) print_row(rows[i]);
    return true;
  });
  if (asked.json) {
    print_json(rows, row_json);
    return;
  }
  for (const std::string& vehicle : asked.vehicles) print_totals(vehicle, rows);
}

}  // namespace headland::bench
