#include "apps/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "evaluate/duration_text.h"

namespace headland {

ProgressLine start_progress(bool quiet) {
  ProgressLine line;
  line.shown = !quiet && ::isatty(STDERR_FILENO) != 0;
  line.start = ProgressLine::Clock::now();
  return line;
}

void show_progress(ProgressLine& line, const SimulationProgress& progress) {
  if (!line.shown) return;
  const auto now = ProgressLine::Clock::now();
  if (now - line.last < std::chrono::milliseconds(100)) return;
  line.last = now;
  const double wall_s = std::chrono::duration<double>(now - line.start).count();
  const double fraction = progress.path_fraction;
  const std::string left =
      fraction > 0.01 ? duration_text(wall_s * (1.0 - fraction) / fraction) + " left" : "";
  // The escape clears what a longer line left behind.
  fmt::print(stderr, "\r\x1b[K  driving  {:3.0f} %   {} simulated   {:.0f}x real time   {}",
             100.0 * fraction, duration_text(progress.time_s),
             wall_s > 0.0 ? progress.time_s / wall_s : 0.0, left);
  std::fflush(stderr);
}

void show_share(ProgressLine& line, std::string_view what, double share) {
  if (!line.shown) return;
  const auto now = ProgressLine::Clock::now();
  if (now - line.last < std::chrono::milliseconds(100)) return;
  line.last = now;
  const double wall_s = std::chrono::duration<double>(now - line.start).count();
  fmt::print(stderr, "\r\x1b[K  {}  {:3.0f} %   {}", what, 100.0 * share,
             share > 0.01 ? duration_text(wall_s * (1.0 - share) / share) + " left" : "");
  std::fflush(stderr);
}

void end_progress(const ProgressLine& line) {
  if (line.shown) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace headland
