// The one exception for bad input: a file, a parameter or a geometry that cannot be used.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace headland {

// Bad input. what() is the one line that the command prints before it exits with code 2:
//   "SOURCE: WHERE: 'VALUE': ALLOWED"
// Empty parts are left out of the line, and a very long value is cut there.
struct InputError : std::runtime_error {
  // source: file or command-line option; where: key path or "line 12"; value: what stood there;
  // allowed: what would be accepted, with its unit, or what is wrong and what would mend it.
  InputError(std::string source, std::string where, std::string value, std::string allowed);

  std::string source;
  std::string where;
  std::string value;
  std::string allowed;
};

// The candidate that begins with `word`, else the nearest by edit distance; empty when `candidates`
// is empty.
std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

// What an InputError says is allowed instead of an unknown name: "unknown view; did you mean 'map'?
// (known: map, chase)". `what` is what is named.
std::string unknown_name(std::string_view what, std::string_view word,
                         const std::vector<std::string>& known);

}  // namespace headland
