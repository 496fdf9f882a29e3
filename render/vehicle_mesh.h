// A vehicle's body: its mesh, wheels and implement.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "render/mesh.h"
#include "render/relief.h"
#include "sim/run_record.h"
#include "vehicle_models/vehicle.h"

namespace headland {

struct VehicleMesh {
  Mesh mesh;                       // in frame B
  std::string note;                // why the body is a plain box; empty when it is not
  std::vector<std::string> lacks;  // materials and textures it is drawn without, a sentence each
};

// The body alone: from the vehicle's shapes, or a plain box of the hull's size when there are
// none or a mesh cannot be read.
VehicleMesh body_mesh(const Vehicle& vehicle);

// A wheel alone, its axis along y through the origin.
Mesh wheel_mesh(const Axle& axle);

// The implement alone in frame B, a trailed one straight behind; empty without one.
Mesh implement_mesh(const Vehicle& vehicle, bool down);

// The vehicle's notes, and why its body is a plain box unless they say so already.
std::vector<std::string> vehicle_notes(const Vehicle& vehicle);

// The body, wheels turned and steered, implement lowered or raised as in the sample, a trailed one
// at its hitch angle in the vehicle's own plane.
VehicleMesh vehicle_mesh(const Vehicle& vehicle, const RunSample& sample);

// The same around a body_mesh that is there already: reading one takes longer than drawing it.
Mesh moved_vehicle_mesh(const Vehicle& vehicle, const Mesh& body, const RunSample& sample);

// Place and attitude of B in D. The attitude follows the stretched relief.
Eigen::Isometry3d pose_in_D(const RunSample& sample, const Relief& relief);

}  // namespace headland
