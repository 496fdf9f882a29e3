// One made-up field planned for one vehicle, and what the audit says of the path.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "evaluate/audit.h"
#include "evaluate/scenario.h"
#include "terrains/field_generator.h"

namespace headland::bench {

struct SuiteRow {
  FieldRecipe recipe;
  std::string vehicle;
  std::string refusal;  // empty: planned
  double plan_s = 0.0;
  double path_s = 0.0;
  double audit_s = 0.0;
  std::size_t passes = 0;
  double length_m = 0.0;
  double work_m = 0.0;
  std::size_t states_outside = 0;  // hull outside, in a hole or in an obstacle
  std::size_t other_faults = 0;    // places too tight, jumps
  double field_m2 = 0.0;
  double reachable_m2 = 0.0;
  double missed_m2 = 0.0;   // of the reachable ground
  double overlap_m2 = 0.0;  // of the field
  double outside_m2 = 0.0;
  std::vector<GroundPatch> missed;  // reachable, at least kLeastPatch_m2
  std::vector<AuditPlace> faults;
  std::vector<LeftOutPass> left_out;
};

// The scenario's vehicle, planner and path options on the recipe's field, on flat ground.
struct SuiteField {
  Scenario scenario;
  Stage stage;
  Path path;
};

// Plans and audits. What is refused has a reason and nothing else; `kept` may be null.
SuiteRow suite_row(const FieldRecipe& recipe, const std::string& vehicle,
                   const Parameters& parameters, double clearance_m, SuiteField* kept = nullptr);

// Of the coverage raster [m]: fine on small fields, where slivers tell.
double coverage_cell_m(const Field& field);
double covered_percent(const SuiteRow& row);  // of the reachable ground
nlohmann::ordered_json row_json(const SuiteRow& row);
// What of a row the table shows, back from row_json.
SuiteRow row_of(const nlohmann::json& json, const FieldRecipe& recipe);

}  // namespace headland::bench
