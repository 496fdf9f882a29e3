// One rewriting line on standard error while a run goes on; nothing when that is not a terminal.
#pragma once

#include <chrono>
#include <string_view>

#include "planner/cancel.h"
#include "sim/simulation.h"

namespace headland {

struct ProgressLine {
  using Clock = std::chrono::steady_clock;

  bool shown = false;
  Clock::time_point start{};
  Clock::time_point last{};
};

// Starts the clock; shows nothing when `quiet` or standard error is not a terminal.
ProgressLine start_progress(bool quiet);

// Simulated time, speed factor, share done and time left, at most ten times a second.
void show_progress(ProgressLine& line, const SimulationProgress& progress);

// The same for work that is not a drive: "measuring  40 %   12 s left".
void show_share(ProgressLine& line, std::string_view what, double share);

// The same for work that is counted: "12 of 40 runs   3.1 a second   9 s left".
void show_count(ProgressLine& line, std::string_view what, int done, int all);

// The same for work of unknown length: "planning   12 s", from the first second on.
void show_elapsed(ProgressLine& line, std::string_view what);

// Clears the line.
void end_progress(const ProgressLine& line);

// Shows for how long there has been planning while it lives. How much is left depends on ways that
// are still to be found.
class PlanningLine {
 public:
  explicit PlanningLine(bool quiet) : line_(start_progress(quiet)) {}
  ~PlanningLine() { end_progress(line_); }
  PlanningLine(const PlanningLine&) = delete;
  PlanningLine& operator=(const PlanningLine&) = delete;

  // To be asked by what plans, and to live no longer than this; never asks it to end.
  CancelAsked shown();

 private:
  ProgressLine line_;
};

}  // namespace headland
