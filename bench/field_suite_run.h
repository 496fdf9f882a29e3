// The suite of made-up fields planned for several vehicles: a table with totals.
#pragma once

#include <string>
#include <vector>

#include "terrains/parameter.h"

namespace headland::bench {

struct SuiteAsked {
  int fields = 200;
  int first = 0;  // so many of the suite are left out before
  double least_ha = 0.0;
  double most_ha = 1e9;
  int jobs = 2;
  std::vector<std::string> vehicles = {"transplanter", "utility_tractor"};
  std::vector<std::string> set;  // KEY=VALUE, as asked, of which are:
  Parameters parameters;
  // JSON, a row a line: rows are appended as they come; those that are there for the same
  // parameters are not made again. None: empty.
  std::string rows_file;
  bool again = false;  // make refused rows, and those short of what is wanted, again nevertheless
  bool json = false;
};

inline constexpr double kWantedPercent = 99.5;  // of the reachable ground

// Throws InputError for a file that cannot be read or written.
void print_suite(const SuiteAsked& asked);

}  // namespace headland::bench
