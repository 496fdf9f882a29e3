// The cost table as YAML and CSV.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "evaluate/cost_table.h"
#include "evaluate/run_tables.h"
#include "evaluate/yaml_section.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr double kMostCost = 1e12;
constexpr NumberRange kAnyCost{-kMostCost, kMostCost};

struct NumberOfTable {
  const char* key;
  double CostTable::*value;
};
constexpr NumberOfTable kTableNumbers[] = {
    {"mass_kg", &CostTable::mass_kg},
    {"working_width_m", &CostTable::working_width_m},
    {"turning_radius_m", &CostTable::turning_radius_m},
    {"work_speed_mps", &CostTable::work_speed_mps},
    {"rate_hz", &CostTable::rate_hz},
    {"formula_mu", &CostTable::formula_mu},
    {"formula_turn_power_w", &CostTable::formula_turn_power_w},
};

struct NumberOfManoeuvre {
  const char* key;
  double Manoeuvre::*value;
};
constexpr NumberOfManoeuvre kManoeuvreNumbers[] = {
    {"speed_mps", &Manoeuvre::speed_mps},
    {"slope_along", &Manoeuvre::slope_along},
    {"slope_across", &Manoeuvre::slope_across},
    {"row_spacing_m", &Manoeuvre::row_spacing_m},
};

struct EstimateKey {
  const char* key;
  Estimate MeasuredCost::*value;
};
constexpr EstimateKey kEstimates[] = {
    {"energy_j", &MeasuredCost::energy_j},
    {"time_s", &MeasuredCost::time_s},
    {"distance_m", &MeasuredCost::distance_m},
    {"slip", &MeasuredCost::slip},
    {"scuffed_m2", &MeasuredCost::scuffed_m2},
    {"peak_power_w", &MeasuredCost::peak_power_w},
    {"marginal_energy_j", &MeasuredCost::marginal_energy_j},
    {"marginal_time_s", &MeasuredCost::marginal_time_s},
};

// 7 digits: more than any of it is known to.
std::string shown_cost(double value) { return fmt::format("{:.7g}", value); }

void emit_value(YAML::Emitter& out, const char* key, const std::string& value) {
  out << YAML::Key << key << YAML::Value << value;
}

void emit_cost(YAML::Emitter& out, const MeasuredCost& cost) {
  const Manoeuvre& manoeuvre = cost.manoeuvre;
  out << YAML::BeginMap;
  emit_value(out, "manoeuvre", std::string(manoeuvre_name(manoeuvre.kind)));
  emit_value(out, "implement_down", manoeuvre.implement_down ? "true" : "false");
  for (const NumberOfManoeuvre& number : kManoeuvreNumbers) {
    emit_value(out, number.key, fmt::format("{}", manoeuvre.*number.value));
  }
  emit_value(out, "outcome", std::string(outcome_name(cost.outcome)));
  if (cost.outcome != Outcome::kFinished) {
    emit_value(out, "outcome_detail", cost.outcome_detail);
    out << YAML::EndMap;
    return;
  }
  for (const EstimateKey& estimate : kEstimates) {
    out << YAML::Key << estimate.key << YAML::Value << YAML::Flow << YAML::BeginMap;
    emit_value(out, "mean", shown_cost((cost.*estimate.value).mean));
    const auto& ci95 = (cost.*estimate.value).ci95;
    if (ci95) emit_value(out, "ci95", shown_cost(*ci95));
    out << YAML::EndMap;
  }
  out << YAML::Key << "causes" << YAML::Value << YAML::BeginMap;
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    emit_value(out, energy_key(static_cast<EnergyCause>(i)).c_str(), shown_cost(cost.cause_j[i]));
  }
  out << YAML::EndMap;
  emit_value(out, "formula_j", shown_cost(cost.formula_j));
  emit_value(out, "formula_as_printed_j", shown_cost(cost.formula_as_printed_j));
  out << YAML::EndMap;
}

[[noreturn]] void refuse_key(const YamlSection& section, std::string_view key,
                             const std::string& value, const std::string& allowed) {
  throw InputError(section.source, place_of(section, key), value, allowed);
}

double needed_number(const YamlSection& section, std::string_view key, const NumberRange& range) {
  const auto number = read_number(section, key, range);
  if (!number) refuse_key(section, key, "", "a number is needed here");
  return *number;
}

std::string needed_word(const YamlSection& section, std::string_view key) {
  const auto word = read_word(section, key);
  if (!word) refuse_key(section, key, "", "a word is needed here");
  return *word;
}

template <typename Enum>
Enum named(const YamlSection& section, std::string_view key, Enum last,
           std::string_view (*name)(Enum)) {
  const std::string word = needed_word(section, key);
  std::vector<std::string> known;
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    known.emplace_back(name(static_cast<Enum>(i)));
    if (known.back() == word) return static_cast<Enum>(i);
  }
  refuse_key(section, key, word, fmt::format("one of: {}", fmt::join(known, ", ")));
}

MeasuredCost read_cost(const YamlSection& section) {
  MeasuredCost cost;
  Manoeuvre& manoeuvre = cost.manoeuvre;
  manoeuvre.kind = named(section, "manoeuvre", ManoeuvreKind::kPivotTurn, manoeuvre_name);
  manoeuvre.implement_down = read_flag(section, "implement_down").value_or(false);
  for (const NumberOfManoeuvre& number : kManoeuvreNumbers) {
    manoeuvre.*number.value = needed_number(section, number.key, kAnyCost);
  }
  cost.outcome = named(section, "outcome", Outcome::kInterrupted, outcome_name);
  if (cost.outcome != Outcome::kFinished) {
    cost.outcome_detail = read_word(section, "outcome_detail").value_or("");
    return cost;
  }
  for (const EstimateKey& estimate : kEstimates) {
    const auto pair = read_section(section, estimate.key);
    if (!pair) refuse_key(section, estimate.key, "", "a mean and its ci95 are needed here");
    refuse_unknown_keys(*pair, {"mean", "ci95"});
    (cost.*estimate.value).mean = needed_number(*pair, "mean", kAnyCost);
    (cost.*estimate.value).ci95 = read_number(*pair, "ci95", kAnyCost);
  }
  const auto causes = read_section(section, "causes");
  if (!causes) refuse_key(section, "causes", "", "the energy by cause is needed here");
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    cost.cause_j[i] = needed_number(*causes, energy_key(static_cast<EnergyCause>(i)), kAnyCost);
  }
  cost.formula_j = needed_number(section, "formula_j", kAnyCost);
  cost.formula_as_printed_j = needed_number(section, "formula_as_printed_j", kAnyCost);
  return cost;
}

}  // namespace

std::string cost_table_yaml(const CostTable& table) {
  YAML::Emitter out;
  out << YAML::Comment("What driving costs, measured by 'headland measure'. Keys: docs/costs.md");
  out << YAML::BeginMap;
  emit_value(out, "vehicle", table.vehicle);
  emit_value(out, "soil", table.soil);
  for (const NumberOfTable& number : kTableNumbers) {
    emit_value(out, number.key, shown_cost(table.*number.value));
  }
  out << YAML::Key << "micro_relief" << YAML::Value << YAML::Flow << YAML::BeginMap;
  emit_value(out, "rms_m", fmt::format("{}", table.micro_relief.rms_m));
  emit_value(out, "correlation_m", fmt::format("{}", table.micro_relief.correlation_m));
  out << YAML::EndMap;
  emit_value(out, "seed", fmt::format("{}", table.seed));
  emit_value(out, "repeats", fmt::format("{}", table.repeats));
  out << YAML::Key << "costs" << YAML::Value << YAML::BeginSeq;
  for (const MeasuredCost& cost : table.costs) emit_cost(out, cost);
  out << YAML::EndSeq << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

CostTable read_cost_table(const std::filesystem::path& file) {
  const YamlSection section = read_yaml(file);
  CostTable table;
  table.vehicle = needed_word(section, "vehicle");
  table.soil = needed_word(section, "soil");
  for (const NumberOfTable& number : kTableNumbers) {
    table.*number.value = needed_number(section, number.key, {0.0, kMostCost});
  }
  if (const auto relief = read_section(section, "micro_relief")) {
    table.micro_relief.rms_m = needed_number(*relief, "rms_m", {0.0, kMaxRoughness_m});
    table.micro_relief.correlation_m =
        needed_number(*relief, "correlation_m", {kMinCorrelation_m, kMaxCorrelation_m});
  }
  table.seed = read_whole_number(section, "seed").value_or(1);
  table.repeats = static_cast<int>(needed_number(section, "repeats", {1.0, 1e6}));
  const auto costs = read_sections(section, "costs");
  if (!costs || costs->empty()) refuse_key(section, "costs", "", "at least one cost is needed");
  for (const YamlSection& cost : *costs) table.costs.push_back(read_cost(cost));
  return table;
}

std::string cost_table_csv(const CostTable& table) {
  std::string text =
      "manoeuvre,implement_down,speed_mps,slope_along,slope_across,row_spacing_m,outcome";
  for (const EstimateKey& column : kEstimates) {
    text += fmt::format(",{0},{0}_ci95", column.key);
  }
  for (std::size_t i = 0; i < kEnergyCauses; ++i) {
    text += fmt::format(",{}", energy_key(static_cast<EnergyCause>(i)));
  }
  text += ",formula_j,formula_as_printed_j\n";
  for (const MeasuredCost& cost : table.costs) {
    const Manoeuvre& m = cost.manoeuvre;
    text += fmt::format("{},{:d},{:g},{:g},{:g},{:g},{}", manoeuvre_name(m.kind), m.implement_down,
                        m.speed_mps, m.slope_along, m.slope_across, m.row_spacing_m,
                        outcome_name(cost.outcome));
    const bool known = cost.outcome == Outcome::kFinished;
    const auto cell = [&](std::optional<double> value) {
      text += known && value ? fmt::format(",{:.6g}", *value) : std::string(",");
    };
    for (const EstimateKey& column : kEstimates) {
      cell((cost.*column.value).mean);
      cell((cost.*column.value).ci95);
    }
    for (const double cause_j : cost.cause_j) cell(cause_j);
    cell(cost.formula_j);
    cell(cost.formula_as_printed_j);
    text += "\n";
  }
  return text;
}

}  // namespace headland
