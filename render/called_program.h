// Programs that headland calls: ffmpeg, gnuplot.
#pragma once

#include <csignal>
#include <string>

namespace headland {

// Throws InputError that names the Debian package when PATH has no such program. `does`: what for,
// as in "it draws the charts".
void require_program(const std::string& name, const std::string& does, const std::string& package);

// While one lives, writing to a program that has ended fails instead of ending this one.
struct BrokenPipesIgnored {
  void (*before)(int) = std::signal(SIGPIPE, SIG_IGN);

  BrokenPipesIgnored() = default;
  ~BrokenPipesIgnored() { std::signal(SIGPIPE, before); }
  BrokenPipesIgnored(const BrokenPipesIgnored&) = delete;
  BrokenPipesIgnored& operator=(const BrokenPipesIgnored&) = delete;
};

}  // namespace headland
