#include "evaluate/cost_table.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace headland {
Estimate estimate_of(const std::vector<double>& values) {
  Estimate estimate;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) estimate.mean += value / n;
  if (values.size() < 2) return estimate;
  double squares = 0.0;
  for (const double value : values) squares += (value - estimate.mean) * (value - estimate.mean);
  const boost::math::students_t spread(n - 1.0);
  constexpr double kUpperTail = 0.025;
  estimate.ci95 = boost::math::quantile(boost::math::complement(spread, kUpperTail)) *
                  std::sqrt(squares / (n - 1.0) / n);
  return estimate;
}

}  // namespace headland
