// For writing to programs that may have ended.
#pragma once

#include <csignal>

namespace headland {

// While one lives, writing to a program that has ended fails instead of ending this one.
struct BrokenPipesIgnored {
  void (*before)(int) = std::signal(SIGPIPE, SIG_IGN);

  BrokenPipesIgnored() = default;
  ~BrokenPipesIgnored() { std::signal(SIGPIPE, before); }
  BrokenPipesIgnored(const BrokenPipesIgnored&) = delete;
  BrokenPipesIgnored& operator=(const BrokenPipesIgnored&) = delete;
};

}  // namespace headland
