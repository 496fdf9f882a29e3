// What a refused input says, for tests.
#pragma once

#include <string>

#include "terrains/input_error.h"

namespace headland {

// The one line of the InputError that `call` throws; "accepted" when it throws none.
template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace headland
