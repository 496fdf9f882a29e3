// Figures of a benchmark: printed as a table, or as JSON for machines.
#pragma once

#include <fmt/format.h>
#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace headland::bench {

// Rows for machines.
template <typename Row>
void print_json(const std::vector<Row>& rows, nlohmann::ordered_json (*json_of)(const Row&)) {
  auto json = nlohmann::ordered_json::array();
  for (const Row& row : rows) json.push_back(json_of(row));
  std::puts(json.dump(2).c_str());
}

struct Figure {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::string target;  // what issue or paper asks for, empty when nothing does
};

inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of this thread: what others run at the same time does not count.
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The most memory [bytes] that the program has held so far.
inline double peak_memory_bytes() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return 1024.0 * static_cast<double>(used.ru_maxrss);
}

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

inline void print(const std::vector<Figure>& figures, bool as_json) {
  if (as_json) {
    auto out = nlohmann::ordered_json::array();
    for (const Figure& figure : figures) {
      out.push_back({{"name", figure.name},
                     {"value", figure.value},
                     {"unit", figure.unit},
                     {"target", figure.target}});
    }
    std::puts(out.dump(2).c_str());
    return;
  }
  for (const Figure& figure : figures) {
    std::puts(fmt::format("{:<58} {:>12.6g} {:<10} {}", figure.name, figure.value, figure.unit,
                          figure.target)
                  .c_str());
  }
}

inline bool wants_json(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc,
                     [](const char* word) { return std::string_view(word) == "--json"; });
}

}  // namespace headland::bench
