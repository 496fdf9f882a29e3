// The keys of a sweep's file, for the test of the documentation.
#pragma once

#include <string>
#include <vector>

namespace headland {

// Every key path that is not one of a scenario.
std::vector<std::string> sweep_key_paths();

}  // namespace headland
