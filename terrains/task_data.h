// Task data of ISO 11783-10 (TASKDATA.XML, "ISOXML"): partfields with their outlines, and the
// guidance lines in them. Read in versions 2 to 4, written in version 4.3. Everything else that
// such a file holds (tasks, devices, products, logs) is passed over.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace headland {

// Attribute A of PLN, LSG, PNT and attribute C of GPN, by the standard's numbers. Others are kept
// as the number they are.
enum class TaskPolygonType {
  kBoundary = 1,
  kWater = 3,
  kBuilding = 4,
  kObstacle = 6,
  kWindbreak = 12,
};
enum class TaskLineType { kExterior = 1, kInterior = 2, kGuidance = 5, kFence = 7, kObstacle = 9 };
enum class TaskPointType {
  kOther = 2,
  kFieldAccess = 3,
  kObstacle = 5,
  kGuidanceA = 6,
  kGuidanceB = 7,
  kGuidancePoint = 9,
};
enum class GuidanceKind { kAb = 1, kAPlus = 2, kCurve = 3, kPivot = 4, kSpiral = 5 };
// Attribute E of GPN: to which sides a terminal draws parallels.
enum class Propagation { kBoth = 1, kNone = 4 };

// Degrees WGS 84, longitude (attribute D, PointEast) first, then latitude (C, PointNorth).
struct TaskPoint {
  TaskPointType type = TaskPointType::kOther;
  std::string name;
  Eigen::Vector2d lon_lat_deg = Eigen::Vector2d::Zero();
};

// LSG. A ring does not repeat its first point.
struct TaskLine {
  TaskLineType type = TaskLineType::kExterior;
  std::string name;
  double width_m = 0.0;  // 0: not told
  std::vector<Eigen::Vector2d> lon_lat_deg;
};

// PLN.
struct TaskPolygon {
  TaskPolygonType type = TaskPolygonType::kBoundary;
  std::string name;
  std::vector<TaskLine> rings;
};

// GPN: a line to drive along. `repeats` where the terminal draws parallels to it, working width
// (width_m of the line) by working width; not repeated, it is one pass.
struct GuidancePattern {
  std::string group;  // designator of its GGP; empty for lines of versions before 4
  std::string name;
  GuidanceKind kind = GuidanceKind::kAb;
  bool repeats = true;
  TaskLine line;
};

// PFD.
struct Partfield {
  std::string id;
  std::string code;
  std::string name;
  double area_m2 = 0.0;
  std::vector<TaskPolygon> polygons;
  std::vector<TaskLine> lines;
  std::vector<TaskPoint> points;
  std::vector<GuidancePattern> guidance;
};

struct TaskData {
  std::vector<Partfield> partfields;
};

// Whether `file` is task data: XML of that root, or a folder with a TASKDATA.XML. Throws InputError
// for what cannot be read.
bool is_task_data(const std::filesystem::path& file);

// Reads it, with the files it refers to (XFR). XML entities other than the five of the language are
// not expanded and no document type is followed. Throws InputError with the line: malformed XML, an
// attribute that is missing, no number or out of its range, points kept in a binary file.
TaskData read_task_data(const std::filesystem::path& file);

// As the text of a TASKDATA.XML; ids are given in the order of the parts. Degrees have 10 decimals
// (11 um), widths whole millimetres, areas whole square metres; names are cut to the 32 characters
// that the standard allows.
std::string task_data_text(const TaskData& data, const std::string& version);

}  // namespace headland
