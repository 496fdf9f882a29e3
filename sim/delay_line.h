// Values that arrive a fixed number of steps late.
#pragma once

#include <cmath>
#include <vector>

namespace headland {

template <typename T>
struct DelayLine {
  std::vector<T> waiting;  // as many as the delay has steps
  std::size_t next = 0;

  // Puts a value in and takes out the one that has waited.
  T pass(const T& value) {
    if (waiting.empty()) return value;
    const T late = waiting[next];
    waiting[next] = value;
    next = (next + 1) % waiting.size();
    return late;
  }
};

// Until the first value has passed, `first` comes out.
template <typename T>
DelayLine<T> make_delay_line(double latency_s, double rate_hz, const T& first) {
  DelayLine<T> line;
  line.waiting.assign(static_cast<std::size_t>(std::lround(latency_s * rate_hz)), first);
  return line;
}

}  // namespace headland
