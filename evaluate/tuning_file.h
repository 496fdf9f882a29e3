// The results of a tuning as files.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "evaluate/tuning_run.h"

namespace headland {

inline constexpr char kTuningFile[] = "tune.json";
inline constexpr char kWeightsFile[] = "weights.yaml";

// Every key: docs/tune.md. What is not known is null.
nlohmann::ordered_json tuning_json(const Tuning& tuning, const TuneResult& result,
                                   std::string_view version);

// The tuned weights for `plan` and `evaluate`; empty when nothing was tuned.
std::string tuned_weights_yaml(const Tuning& tuning, const TuneResult& result);

}  // namespace headland
