// A stretch of time as people say it.
#pragma once

#include <string>

namespace headland {

// "45 s", "3 min 20 s", "1 h 02 min"; "unknown time" for what is not finite.
std::string duration_text(double seconds);

}  // namespace headland
