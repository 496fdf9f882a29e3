#include "vehicle_models/draft.h"

#include <cmath>

namespace headland {
namespace {

constexpr double kKmhPerMps = 3.6;

}  // namespace

std::span<const D497Tool> d497_tools() {
  static constexpr D497Tool kTools[] = {
      {"sweep_plough", false, 390.0, 19.0, 0.0, {1.0, 0.85, 0.65}},
      {"field_cultivator", true, 46.0, 2.8, 0.0, {1.0, 0.85, 0.65}},
      {"chisel_plough", true, 91.0, 5.4, 0.0, {1.0, 0.85, 0.65}},
      {"mouldboard_plough", false, 652.0, 0.0, 5.1, {1.0, 0.70, 0.45}},
      {"subsoiler", true, 226.0, 0.0, 1.8, {1.0, 0.70, 0.45}},
      {"row_planter", true, 500.0, 0.0, 0.0, {1.0, 1.0, 1.0}, true},
  };
  return kTools;
}

double draft_n(const Implement& implement, SoilTexture texture, double speed_mps) {
  if (!implement.tillage) return implement.draft_n_per_m * implement.working_width_m;
  const TillageDraft& law = *implement.tillage;
  const double speed_kmh = kKmhPerMps * std::abs(speed_mps);
  const double units = law.tools > 0 ? law.tools : implement.working_width_m;
  return law.texture_factor[static_cast<std::size_t>(texture)] *
         (law.a + speed_kmh * (law.b + speed_kmh * law.c)) * units * law.depth_cm;
}

}  // namespace headland
