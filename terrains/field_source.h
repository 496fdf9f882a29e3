// Where a field comes from: a vector file, coordinates in the scenario, or a grid map.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "terrains/field.h"

namespace headland {

// One obstacle as it is given: at a point (trees, poles, rocks) or along a line (walls, fences).
struct ObstacleSource {
  ObstacleKind kind = ObstacleKind::kTree;
  std::vector<Eigen::Vector2d> line;  // one point, or at least two
  double radius_m = 0.3;              // half the thickness of walls and fences
  double height_m = 5.0;
  std::string place = "field.obstacles";  // in the scenario, for messages
};

// What stands at a point or along a line with nothing else said.
ObstacleSource default_obstacle(ObstacleKind kind);

// As a scenario gives it. Coordinates are x,y in `crs` (east or longitude first); an empty crs with
// inline coordinates means plain local metres (W itself, with no place on the earth), and with a
// file means the file's own CRS (GeoJSON: WGS 84, RFC 7946). A crs given with a file overrules it.
struct FieldSource {
  std::filesystem::path file;  // empty: inline coordinates
  // A grid map's picture (read_grid_map) instead of a file or coordinates, and see field_of_grid;
  // such a field has no place on the earth, and its entry is in metres.
  std::filesystem::path grid_map;
  double cell_m = 1.0;
  double margin_m = 0.0;
  std::string layer;  // empty: the only or first layer with polygons
  std::string part;   // of several polygons: a name (partfield: designator, code, id) or number
  std::string crs;
  std::optional<GeoFrame> frame;  // to be brought into; none: one with its origin in the field
  Ring boundary;
  std::vector<Ring> holes;
  std::vector<Ring> to_work;              // inline: outlines of the ground to be worked, see Field
  std::vector<ObstacleSource> obstacles;  // in `crs` (of the file: WGS 84 longitude, latitude)
  std::optional<Eigen::Vector2d> entry;   // likewise
  std::string entry_place = "field.entry";  // in the scenario, for messages
};

// Reads a field from anything GDAL's vector drivers read (GeoJSON, GPKG, shapefile, KML, GML), from
// ISO 11783-10 task data, or from inline coordinates, brings it into the local frame W whose origin
// is the boundary's centre rounded to 1e-4 deg, orients and checks the rings, and simplifies those
// of more than kManyPoints points (rough ones inside the field) and tells `notes` within how much.
// Features of the file with a property `obstacle` (a kind: tree, pole, rock, wall, fence) are
// obstacles: points with radius_m, lines with thickness_m, both with height_m; a line becomes one
// obstacle for each straight piece. `source` is the scenario's file name for messages. Throws
// InputError: missing or unreadable file, no polygon, several polygons and none chosen (lists
// them), no CRS, empty or self-intersecting boundary (with the place), hole or obstacle or entry
// outside the field, NaN, degrees taken for metres, an obstacle of unknown kind, wrong shape or
// size.
Field read_field(const FieldSource& field, const std::string& source,
                 std::vector<std::string>* notes = nullptr);

// Establishes Field's invariants on rings already in W: repeated points are merged, a closing
// point is dropped, rings are oriented. Throws InputError as above. Not the entry's: see below.
void check_field(Field& field, const std::string& source);

// Throws InputError for an outline of the ground to be worked that bounds no area.
void check_to_work(Field& field, const std::string& source);

// Throws InputError unless the entry, if there is one, lies in the field.
void check_entry(const Field& field, const std::string& source, const std::string& where);

// The same for one obstacle of a field whose rings are established.
void check_obstacle(const Field& field, const Obstacle& obstacle, const std::string& source,
                    const std::string& where);

// Points nearer than this are one point, and rings nearer than this touch.
inline constexpr double kSamePlace_m = 1e-3;
// Rings of more points are simplified; what is left out lies so near the lines that remain.
inline constexpr std::size_t kManyPoints = 5000;
inline constexpr double kOutlineRounding_m = 0.005;
// Outside of these a boundary is taken for coordinates in the wrong CRS.
inline constexpr double kMinFieldExtent_m = 1.0;
// Of fields in metres without a place on the earth: less is degrees whose CRS is missing.
inline constexpr double kLeastPlainExtent_m = 5.0;
inline constexpr double kMaxFieldExtent_m = 20e3;
// A gate may be digitised this far outside the boundary.
inline constexpr double kEntryTolerance_m = 1.0;
// Radius and height of an obstacle.
inline constexpr double kMinObstacle_m = 0.01;
inline constexpr double kMaxObstacleRadius_m = 50.0;
inline constexpr double kMinThickness_m = 2.0 * kMinObstacle_m;  // of walls and fences
inline constexpr double kMaxThickness_m = 10.0;
inline constexpr double kMaxObstacleHeight_m = 100.0;
// Walls and fences may run this far outside the boundary.
inline constexpr double kObstacleReach_m = 100.0;
inline constexpr int kMostWallPieces = 1000;  // planning looks at each

}  // namespace headland
