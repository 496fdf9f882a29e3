#include "terrains/track.h"

#include <fmt/format.h>
#include <ogr_core.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <utility>

#include "terrains/field_source.h"
#include "terrains/given_track.h"
#include "terrains/input_error.h"
#include "terrains/task_data.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

// A field is larger than this in metres and smaller in degrees.
constexpr double kLargestDegreeSpan = 0.5;

// A receiver at rest wanders by this: a shorter step has no direction.
constexpr double kStandstill_m = 1.0;

void require_usable_coordinates(const GivenTrack& track, const GeoFrame& frame,
                                const std::string& file) {
  const std::string need =
      "longitude and latitude need a field with a place on the earth; give the crs of the field's "
      "coordinates as field.crs";
  if (track.degrees && !frame.georeferenced) throw InputError(file, "", "", need);
  if (track.degrees) return;
  Eigen::AlignedBox2d box;
  for (const GivenPoint& point : track.points) box.extend(point.given);
  const bool like_degrees = std::abs(box.center().x()) <= 180.0 &&
                            std::abs(box.center().y()) <= 90.0 && box.sizes().maxCoeff() > 0.0 &&
                            box.sizes().maxCoeff() < kLargestDegreeSpan;
  if (like_degrees) {
    throw InputError(
        file, fmt::format("{} {}", track.counted, track.points.front().number),
        fmt::format("{}, {}", track.points.front().given.x(), track.points.front().given.y()),
        "looks like degrees; " +
            (frame.georeferenced ? "x,y are metres, name the columns lon,lat" : need));
  }
}

// What a whole track that lies elsewhere was probably meant to be.
std::string elsewhere_hint(const GivenTrack& given, const GeoFrame& frame) {
  if (given.degrees) return "is it another field's, or are longitude and latitude swapped?";
  if (!frame.georeferenced) return "x,y are metres of the coordinates that the field is given in";
  return fmt::format(
      "x,y are local metres east and north of the field's middle (longitude {:.4f}, latitude "
      "{:.4f}); use lon,lat",
      frame.longitude_deg, frame.latitude_deg);
}

void require_at_field(const GivenTrack& given, const std::vector<Eigen::Vector2d>& points_W,
                      const Field& field, const std::string& file) {
  constexpr double kMetresPerKm = 1000.0;
  constexpr double kWholeKm_m = 10e3;  // tenths are told below
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p_W : field.boundary) box.extend(p_W);
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    const double away_m = box.exteriorDistance(points_W[i]);
    if (away_m <= kMaxMargin_m) continue;
    const Eigen::Vector2d& point = given.points[i].given;
    throw InputError(
        file, fmt::format("{} {}", given.counted, given.points[i].number),
        fmt::format("{}, {}", point.x(), point.y()),
        fmt::format("lies {:.{}f} km from the field '{}': {}", away_m / kMetresPerKm,
                    away_m < kWholeKm_m ? 1 : 0, field.name,
                    i == 0 ? elsewhere_hint(given, field.frame) : "take out the stray point"));
  }
}

void require_no_jump(const GivenTrack& given, const std::vector<Eigen::Vector2d>& points_W,
                     const std::string& file) {
  for (std::size_t i = 1; i < points_W.size(); ++i) {
    const double step_m = (points_W[i] - points_W[i - 1]).norm();
    if (step_m <= kMaxJump_m) continue;
    throw InputError(
        file,
        fmt::format("{}s {} and {}", given.counted, given.points[i - 1].number,
                    given.points[i].number),
        fmt::format("{:.0f} m apart", step_m),
        fmt::format("neighbours at most {} m apart; take out the stray point", kMaxJump_m));
  }
}

// The usual step of a log, from which a jump is told.
double longest_step_m(const GivenTrack& given, const std::vector<Eigen::Vector2d>& points_W) {
  std::vector<double> steps_m;
  for (std::size_t i = 1; i < points_W.size(); ++i) {
    const double step_m = (points_W[i] - points_W[i - 1]).norm();
    if (given.points[i].joined && !given.points[i].after_pause && step_m > kSamePlace_m) {
      steps_m.push_back(step_m);
    }
  }
  return steps_m.empty() ? 0.0 : kLogGapFactor * upper_median(std::move(steps_m));
}

// The direction of a step; none where it is too short to have one.
std::optional<Eigen::Vector2d> direction(const Eigen::Vector2d& from_W,
                                         const Eigen::Vector2d& to_W) {
  if ((to_W - from_W).norm() < kStandstill_m) return std::nullopt;
  return (to_W - from_W).normalized();
}

// Whether the vehicle went on elsewhere after the pause before point `i`, or another way.
bool resumed_elsewhere(const std::vector<Eigen::Vector2d>& section_W, const GivenTrack& given,
                       const std::vector<Eigen::Vector2d>& points_W, std::size_t i,
                       double longest_step_m) {
  const Eigen::Vector2d& stopped_W = section_W.back();
  if ((points_W[i] - stopped_W).norm() > longest_step_m) return true;
  std::optional<Eigen::Vector2d> last;
  if (section_W.size() > 1) last = direction(section_W[section_W.size() - 2], stopped_W);
  const auto turns = [&last](const std::optional<Eigen::Vector2d>& next) {
    const bool turned = last && next && last->dot(*next) < std::cos(kPauseTurn_rad);
    if (next) last = next;
    return turned;
  };
  if (turns(direction(stopped_W, points_W[i]))) return true;
  const bool goes_on = i + 1 < points_W.size() && given.points[i + 1].joined;
  return goes_on && turns(direction(points_W[i], points_W[i + 1]));
}

// Repeated points merged, sections of a single point left out: a stray fix is no line.
Track sections_joined(const GivenTrack& given, const std::vector<Eigen::Vector2d>& points_W) {
  Track track;
  track.of_vehicle = given.of_vehicle;
  track.pauses.longest_interval_s = given.longest_interval_s;
  track.pauses.longest_step_m = longest_step_m(given, points_W);
  std::vector<Eigen::Vector2d> section_W;
  const auto finish_section = [&] {
    if (section_W.size() >= 2) {
      if (!track.points_W.empty()) track.break_before.push_back(track.points_W.size());
      track.points_W.insert(track.points_W.end(), section_W.begin(), section_W.end());
    }
    section_W.clear();
  };
  bool after_pause = false;  // also of a point at the place of the last one, which is left out
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    after_pause = after_pause || given.points[i].after_pause;
    if (!section_W.empty() && (points_W[i] - section_W.back()).norm() <= kSamePlace_m) continue;
    const bool resumes = std::exchange(after_pause, false);
    if (!given.points[i].joined) {
      finish_section();
    } else if (resumes && !section_W.empty()) {
      ++track.pauses.count;
      if (resumed_elsewhere(section_W, given, points_W, i, track.pauses.longest_step_m)) {
        ++track.pauses.breaks;
        finish_section();
      }
    }
    section_W.push_back(points_W[i]);
  }
  finish_section();
  return track;
}

// A track as its file gives it, with its points in W.
struct PlacedTrack {
  GivenTrack given;
  std::vector<Eigen::Vector2d> points_W;
};

PlacedTrack placed_track(const std::filesystem::path& path, const Field& field) {
  const GeoFrame& frame = field.frame;
  const std::string file = path.string();
  std::string extension = path.extension().string();
  const bool csv = EQUAL(extension.c_str(), ".csv") || EQUAL(extension.c_str(), ".txt") ||
                   EQUAL(extension.c_str(), ".tsv");
  PlacedTrack track;
  if (csv) {
    track.given = track_from_csv(path, frame);
  } else if (is_task_data(path)) {
    track.given = track_from_task_data(path, field);
  } else {
    track.given = track_from_vector_file(path, frame);
  }
  require_usable_coordinates(track.given, frame, file);
  for (const GivenPoint& point : track.given.points) track.points_W.push_back(point.given);
  if (track.given.degrees) {
    track.points_W = local_from_wgs84(frame, wgs84_from_crs("EPSG:4326", track.points_W, file));
  }
  return track;
}

// Without the points where the implement is up: those after them are not joined to those before.
PlacedTrack working_part(const PlacedTrack& track) {
  PlacedTrack working{track.given, {}};
  working.given.points.clear();
  bool after_raised = false;
  for (std::size_t i = 0; i < track.points_W.size(); ++i) {
    GivenPoint point = track.given.points[i];
    if (!point.down) {
      after_raised = true;
      continue;
    }
    point.joined = !std::exchange(after_raised, false) && point.joined;
    working.given.points.push_back(point);
    working.points_W.push_back(track.points_W[i]);
  }
  return working;
}

}  // namespace

Track read_track(const std::filesystem::path& path, const Field& field) {
  const std::string file = path.string();
  const PlacedTrack placed = working_part(placed_track(path, field));
  require_at_field(placed.given, placed.points_W, field, file);
  require_no_jump(placed.given, placed.points_W, file);
  Track track = sections_joined(placed.given, placed.points_W);
  if (track.points_W.size() < 2) {
    throw InputError(file, "", fmt::format("{} points", placed.given.points.size()),
                     "a track has at least two different points that follow each other");
  }
  return track;
}

std::vector<PathLine> read_path_lines(const std::filesystem::path& path, const Field& field,
                                      std::vector<std::string>* notes) {
  const PlacedTrack placed = placed_track(path, field);
  if (notes != nullptr && placed.given.of_implement) {
    notes->push_back(path.filename().string() +
                     ": its reference is the implement, but its points are taken as the way of the "
                     "vehicle's reference point");
  }
  require_at_field(placed.given, placed.points_W, field, path.string());
  std::vector<PathLine> lines;
  for (std::size_t i = 0; i < placed.points_W.size(); ++i) {
    const GivenPoint& point = placed.given.points[i];
    if (!point.joined) {
      lines.push_back({{}, point.down, false});
    } else if (point.down != lines.back().implement_down) {
      lines.push_back({{lines.back().points_W.back()}, point.down, true});
    }
    lines.back().points_W.push_back(placed.points_W[i]);
  }
  return lines;
}

}  // namespace headland
