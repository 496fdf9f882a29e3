// Which program computed a result.
#pragma once

#include <string_view>

namespace headland {

// The release and a digest of all sources that decide a run's result (terrains to evaluate): two
// programs with the same version give the same runs, and any change to those sources another one.
std::string_view program_version();

}  // namespace headland
