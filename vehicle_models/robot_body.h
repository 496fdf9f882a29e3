// The rigid body that the links of a robot description make, and its hull.
#pragma once

#include <vector>

#include "vehicle_models/robot_file.h"
#include "vehicle_models/running_gear.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// Mass, centre of mass and inertia of all links as one rigid body (parallel axes; products of
// inertia in B are left out: machines are close to symmetric). The hull is the box around every
// link's <collision>, wheels included; its ground clearance is that of the links without wheels.
// Meshes do not count for the hull. Throws InputError for a robot without mass or without a hull.
Body body_of(const Robot& robot, const RunningGear& gear);

// What is drawn of all links but the wheels, in B.
std::vector<Shape> body_shapes(const Robot& robot, const RunningGear& gear);

}  // namespace headland
