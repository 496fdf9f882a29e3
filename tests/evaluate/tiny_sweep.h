// Sweeps of runs that take some ten milliseconds each.
#pragma once

#include <string>

namespace headland {

// Half of its runs have no plan: the field is too small for that vehicle.
inline const std::string kTinySweep =
    "name: tiny\n"
    "seeds: {count: 3}\n"
    "fields: {square: {boundary: [[0, 0], [5, 0], [5, 4], [0, 4]]}}\n"
    "terrains: {rolling: {generator: rolling, amplitude_m: 0.2, wavelength_m: 20, cell_m: 1, "
    "margin_m: 5}}\n"
    "soils: [firm, tilled]\n"
    "vehicles: [skid_steer_robot, horticultural_tractor]\n"
    "planners: {up and down: {name: boustrophedon, headland_passes: 1}}\n"
    "simulation: {rate_hz: 60, record_hz: 1}\n"
    "coverage: {cell_m: 1}\n"
    "path: {allow_overrun: true}\n";
inline constexpr int kTinyRuns = 12;
inline constexpr int kTinyDriven = 6;

}  // namespace headland
