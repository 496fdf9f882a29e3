// What is wrong with a path before anything drives it: any tool's, judged by its points alone.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/coverage.h"
#include "evaluate/ground_patches.h"
#include "planner/path.h"
#include "planner/worked_rows.h"
#include "terrains/field.h"
#include "terrains/track.h"
#include "vehicle_models/vehicle.h"

namespace headland {

enum class AuditFault {
  kOutside,     // hull beyond the boundary
  kInHole,      // hull in a hole
  kInObstacle,  // hull or raised implement in an obstacle
  kTooTight,    // tighter than the vehicle steers
  kJump,        // does not go on where it ended
};
inline constexpr std::array kEveryAuditFault = {AuditFault::kOutside, AuditFault::kInHole,
                                                AuditFault::kInObstacle, AuditFault::kTooTight,
                                                AuditFault::kJump};
std::string_view audit_fault_name(AuditFault fault);

// A stretch of the path with one fault, states of one fault that follow each other.
struct AuditPlace {
  AuditFault fault = AuditFault::kOutside;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  // the worst of it: of hull, corner or jump
  double from_m = 0.0;                            // along the path
  double length_m = 0.0;
  std::size_t states = 0;
  double worst = 0.0;  // [m] depth beyond the limit, radius of the curve, width of the jump
};

struct AuditTotals {
  std::size_t states = 0;
  double length_m = 0.0;
  double worst = 0.0;  // as of the places: the deepest, the tightest, the widest
  int places = 0;
};

struct Audit {
  double length_m = 0.0;
  double working_length_m = 0.0;  // implement down
  double reverse_length_m = 0.0;
  std::size_t states = 0;
  int gear_changes = 0;
  std::array<AuditTotals, kEveryAuditFault.size()> totals;  // by AuditFault
  std::vector<AuditPlace> places;                           // in the path's order
  DrivenOverWorked over_worked;  // any ground worked before, swath or headland
  CoverageRaster raster;
  CoverageFigures coverage;  // of the path as drawn
  // Of at least kLeastPatch_m2, largest first.
  std::vector<GroundPatch> missed;
  std::vector<GroundPatch> overlapped;
};

// The hull stands at states kPathSpacing_m apart or nearer, B's origin on the line and headed along
// the curve that its points are read as (line_headings.h); where the line turns back by more than
// kGearChange_rad, and back again or ends within kLongestReverse_m, the vehicle changes gear and
// keeps its heading. It begins in forward gear. A corner stands for a curve over half of both its
// edges, chords of an arc for that arc, but for none wider than rounds it within
// kCornerTolerance_m. A vehicle that pivots (skid steering) has no limit there. Lines that end and
// begin further apart than kMaxSegmentGap_m (path_check.h) make a jump. Coverage is the implement's
// where it is down, straight across the vehicle at implement.x_B_m. Field and vehicle decide the
// answer, not who made the path. Throws InputError as measure_coverage does, and for lines without
// length.
Audit audit_path(const Field& field, const Vehicle& vehicle, const std::vector<PathLine>& lines,
                 double coverage_cell_m, const std::string& source = "path");

inline constexpr double kGearChange_rad = 2.356;  // 135 deg
inline constexpr double kLongestReverse_m = 30.0;
inline constexpr double kTooTightShare = 0.98;  // of the vehicle's radius: estimates from points
inline constexpr double kLeastPatch_m2 = 1.0;

bool passes(const Audit& audit);

// A path of ours as lines: a segment each, joined to the one before.
std::vector<PathLine> lines_of(const Path& path);

}  // namespace headland
