// Ending long planning early.
#pragma once

#include <functional>

namespace headland {

// Asked again and again while planning, several times a second; true ends it with Cancelled. May be
// empty.
using CancelAsked = std::function<bool()>;

// Planning ended because it was asked to; there is no result.
struct Cancelled {};

inline void stop_if(const CancelAsked& cancelled) {
  if (cancelled && cancelled()) throw Cancelled{};
}

}  // namespace headland
