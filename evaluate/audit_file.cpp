#include "evaluate/audit_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "evaluate/place_json.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShownPerFault = 3;

// Key of a place's worst value.
const char* worst_key(AuditFault fault) {
  switch (fault) {
    case AuditFault::kTooTight:
      return "radius_m";
    case AuditFault::kJump:
      return "gap_m";
    default:
      return "depth_m";
  }
}

std::string_view fault_title(AuditFault fault) {
  switch (fault) {
    case AuditFault::kOutside:
      return "Outside the field";
    case AuditFault::kInHole:
      return "In a hole";
    case AuditFault::kInObstacle:
      return "In an obstacle";
    case AuditFault::kTooTight:
      return "Too tight";
    case AuditFault::kJump:
      return "Jump";
  }
  return "";
}

}  // namespace

std::string audit_place_text(const AuditPlace& place) {
  switch (place.fault) {
    case AuditFault::kOutside:
      return fmt::format("hull {:.2f} m beyond the boundary over {:.1f} m", place.worst,
                         place.length_m);
    case AuditFault::kInHole:
      return fmt::format("hull {:.2f} m in a hole over {:.1f} m", place.worst, place.length_m);
    case AuditFault::kInObstacle:
      return fmt::format("hull or implement {:.2f} m in an obstacle over {:.1f} m", place.worst,
                         place.length_m);
    case AuditFault::kTooTight:
      return fmt::format("curve of {:.2f} m radius over {:.1f} m", place.worst, place.length_m);
    case AuditFault::kJump:
      return fmt::format("goes on {:.2f} m away", place.worst);
  }
  return "";
}

Json audit_json(const Audit& audit, const Field& field, const Vehicle& vehicle,
                const std::string& path_file, const std::string& version) {
  Json json{{"headland", {{"file", "audit"}, {"version", version}}},
            {"field", field.name},
            {"path", path_file},
            {"vehicle", vehicle.name},
            {"passes", passes(audit)},
            {"length_m", audit.length_m},
            {"working_length_m", audit.working_length_m},
            {"reverse_length_m", audit.reverse_length_m},
            {"over_worked_m", audit.over_worked.length_m},
            {"gear_changes", audit.gear_changes},
            {"states", audit.states}};
  for (const AuditFault fault : kEveryAuditFault) {
    const AuditTotals& totals = audit.totals[static_cast<std::size_t>(fault)];
    json["faults"][std::string(audit_fault_name(fault))] = {
        {"places", totals.places},
        {"states", totals.states},
        {"length_m", totals.length_m},
        {worst_key(fault), totals.places > 0 ? Json(totals.worst) : Json(nullptr)}};
  }
  json["places"] = Json::array();
  for (const AuditPlace& place : audit.places) {
    Json entry{{"fault", audit_fault_name(place.fault)}};
    add_place(entry, field.frame, place.p_W);
    entry.update({{"along_m", place.from_m},
                  {"length_m", place.length_m},
                  {"states", place.states},
                  {worst_key(place.fault), place.worst}});
    json["places"].push_back(entry);
  }
  const CoverageFigures& coverage = audit.coverage;
  json["coverage"] = {{"workable_m2", coverage.workable_m2}, {"covered_m2", coverage.covered_m2},
                      {"missed_m2", coverage.missed_m2},     {"overlap_m2", coverage.overlap_m2},
                      {"outside_m2", coverage.outside_m2},   {"cell_m", audit.raster.cell_m}};
  for (const auto& [key, patches] :
       {std::pair("missed", &audit.missed), std::pair("overlapped", &audit.overlapped)}) {
    json[key] = Json::array();
    for (const GroundPatch& patch : *patches) {
      Json entry;
      add_place(entry, field.frame, patch.p_W);
      entry["area_m2"] = patch.area_m2;
      json[key].push_back(entry);
    }
  }
  return json;
}

Verdict audit_verdict(const Audit& audit) {
  Verdict verdict;
  for (const AuditFault fault : kEveryAuditFault) {
    std::vector<AuditPlace> places;
    std::ranges::copy_if(audit.places, std::back_inserter(places),
                         [fault](const AuditPlace& place) { return place.fault == fault; });
    std::ranges::stable_sort(places, [fault](const AuditPlace& a, const AuditPlace& b) {
      return fault == AuditFault::kTooTight ? a.worst < b.worst : a.worst > b.worst;
    });
    places.resize(std::min(places.size(), kShownPerFault));
    for (const AuditPlace& place : places) {
      verdict.reasons.push_back({Grade::kFail, std::string(audit_fault_name(fault)), place.worst,
                                 0.0, place.p_W, std::nullopt,
                                 fmt::format("{}, {:.2f} m", fault_title(fault), place.worst),
                                 audit_place_text(place)});
    }
  }
  for (const GroundPatch& patch : audit.missed) {
    if (&patch - audit.missed.data() >= static_cast<std::ptrdiff_t>(kShownPerFault)) break;
    verdict.reasons.push_back({Grade::kWarn, "missed", patch.area_m2, 0.0, patch.p_W, std::nullopt,
                               fmt::format("Missed, {:.0f} m²", patch.area_m2),
                               fmt::format("{:.0f} m² are never worked", patch.area_m2)});
  }
  verdict.grade = passes(audit) ? Grade::kPass : Grade::kFail;
  return verdict;
}

Path drawn_path(const std::vector<PathLine>& lines) {
  Path path;
  for (const PathLine& line : lines) {
    PathSegment segment;
    segment.kind = line.implement_down ? PathKind::kSwath : PathKind::kTurn;
    segment.implement_down = line.implement_down;
    for (const Eigen::Vector2d& p_W : line.points_W) segment.points.push_back({p_W, 0.0, 0.0});
    path.segments.push_back(std::move(segment));
  }
  return path;
}

}  // namespace headland
