#include "planner/request_check.h"

#include <fmt/format.h>

#include <cmath>

#include "planner/outline.h"
#include "planner/polygon.h"
#include "terrains/field_source.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

void check_request(const PlanRequest& request) {
  const auto positive = [](const char* key, double value_m) {
    if (!(value_m > 0.0) || !std::isfinite(value_m)) {
      throw InputError("plan", key, fmt::format("{}", value_m), "a length above 0 m");
    }
  };
  positive("working_width_m", request.working_width_m);
  positive("turning_radius_m", request.turning_radius_m);
  positive("vehicle_width_m", request.vehicle_width_m);
  std::size_t points = request.field.boundary.size();
  for (const Ring& hole : request.field.holes) points += hole.size();
  if (points > kManyPoints) {
    const Eigen::Vector2d& at_W = request.field.boundary.front();
    throw PlanInfeasible(fmt::format(
        "the outline around ({:.1f}, {:.1f}) m still has {} points when simplified to {} m, more "
        "than {}; draw it with fewer",
        at_W.x(), at_W.y(), points, kOutlineTolerance_m, kManyPoints));
  }
  const double widest_m = 2.0 * widest_disc(from_field(request.field)).radius_m;
  const auto narrow = [&](const char* key, double value_m) {
    if (value_m <= widest_m) return;
    throw InputError("plan", key, fmt::format("{}", value_m),
                     fmt::format("wider than the field '{}' anywhere; at most {:.1f} m",
                                 request.field.name, widest_m));
  };
  narrow("working_width_m", request.working_width_m);
  narrow("vehicle_width_m", request.vehicle_width_m);
}

}  // namespace

PlanRequest checked(const PlanRequest& asked_for) {
  PlanRequest request = asked_for;
  request.field = simplified(asked_for.field);
  check_request(request);
  return request;
}

}  // namespace headland
