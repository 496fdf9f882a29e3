// What `headland tune` found, for the terminal.
#pragma once

#include <string>

#include "evaluate/tuning_run.h"

namespace headland {

std::string tune_summary(const Tuning& tuning, const TuneResult& result);

}  // namespace headland
