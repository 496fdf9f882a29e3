#include "apps/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <string>

#include "evaluate/duration_text.h"

namespace headland {
namespace {

// Seconds since the start when the line is to be written again.
std::optional<double> due_s(ProgressLine& line) {
  if (!line.shown) return std::nullopt;
  const auto now = ProgressLine::Clock::now();
  if (now - line.last < std::chrono::milliseconds(100)) return std::nullopt;
  line.last = now;
  return std::chrono::duration<double>(now - line.start).count();
}

std::string left_text(double wall_s, double share) {
  return share > 0.01 ? duration_text(wall_s * (1.0 - share) / share) + " left" : "";
}

}  // namespace

ProgressLine start_progress(bool quiet) {
  ProgressLine line;
  line.shown = !quiet && ::isatty(STDERR_FILENO) != 0;
  line.start = ProgressLine::Clock::now();
  return line;
}

void show_progress(ProgressLine& line, const SimulationProgress& progress) {
  const auto wall_s = due_s(line);
  if (!wall_s) return;
  // The escape clears what a longer line left behind.
  fmt::print(stderr, "\r\x1b[K  driving  {:3.0f} %   {} simulated   {:.0f}x real time   {}",
             100.0 * progress.path_fraction, duration_text(progress.time_s),
             *wall_s > 0.0 ? progress.time_s / *wall_s : 0.0,
             left_text(*wall_s, progress.path_fraction));
  std::fflush(stderr);
}

void show_share(ProgressLine& line, std::string_view what, double share) {
  const auto wall_s = due_s(line);
  if (!wall_s) return;
  fmt::print(stderr, "\r\x1b[K  {}  {:3.0f} %   {}", what, 100.0 * share,
             left_text(*wall_s, share));
  std::fflush(stderr);
}

void show_count(ProgressLine& line, std::string_view what, int done, int all) {
  const auto wall_s = due_s(line);
  if (!wall_s) return;
  fmt::print(stderr, "\r\x1b[K  {} of {} {}   {:.3g} a second   {}", done, all, what,
             *wall_s > 0.0 ? done / *wall_s : 0.0,
             left_text(*wall_s, static_cast<double>(done) / all));
  std::fflush(stderr);
}

void show_elapsed(ProgressLine& line, std::string_view what) {
  const auto wall_s = due_s(line);
  if (!wall_s || *wall_s < 1.0) return;
  fmt::print(stderr, "\r\x1b[K  {}   {}", what, duration_text(*wall_s));
  std::fflush(stderr);
}

CancelAsked PlanningLine::shown() {
  return [this] {
    show_elapsed(line_, "planning");
    return false;
  };
}

void end_progress(const ProgressLine& line) {
  if (line.shown) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace headland
