#include "evaluate/duration_text.h"

#include <fmt/format.h>

#include <cmath>

namespace headland {

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "unknown time";
  const long long whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02d} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace headland
