#include "evaluate/given_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "terrains/input_error.h"

namespace headland {
namespace {

constexpr std::array<std::pair<std::string_view, MapCorner>, 4> kCorners = {
    {{"north_west", MapCorner::kNorthWest},
     {"north_east", MapCorner::kNorthEast},
     {"south_west", MapCorner::kSouthWest},
     {"south_east", MapCorner::kSouthEast}}};

std::string_view corner_name(MapCorner corner) {
  const auto* found = std::find_if(kCorners.begin(), kCorners.end(),
                                   [&](const auto& named) { return named.second == corner; });
  return found->first;
}

}  // namespace

std::optional<GridCell> cell_of(const std::optional<GivenCell>& given, const GridMap& map) {
  if (!given || std::holds_alternative<FreeChoice>(*given)) return std::nullopt;
  if (const auto* cell = std::get_if<GridCell>(&*given)) return *cell;
  const MapCorner corner = std::get<MapCorner>(*given);
  const bool east = corner == MapCorner::kNorthEast || corner == MapCorner::kSouthEast;
  const bool north = corner == MapCorner::kNorthWest || corner == MapCorner::kNorthEast;
  return GridCell{east ? map.columns - 1 : 0, north ? map.rows - 1 : 0};
}

std::string given_cell_text(const GivenCell& given) {
  if (std::holds_alternative<FreeChoice>(given)) return "free";
  if (const auto* cell = std::get_if<GridCell>(&given)) {
    return fmt::format("[{}, {}]", cell->column, cell->row);
  }
  return std::string(corner_name(std::get<MapCorner>(given)));
}

std::optional<MapCorner> corner_named(std::string_view name) {
  for (const auto& [known, corner] : kCorners) {
    if (known == name) return corner;
  }
  return std::nullopt;
}

std::optional<GivenCell> read_corner(const YamlSection& section, std::string_view key) {
  const YAML::Node mapping = section.node;
  const YAML::Node node = mapping[std::string(key)];
  if (!node.IsDefined()) return std::nullopt;
  constexpr const char* kAllowed =
      "[column, row] counted from 0 in the south-west, free, or a corner: north_west, north_east, "
      "south_west, south_east";
  if (node.IsSequence()) {
    const Eigen::Vector2d point = read_point(section, key).value();
    if (point.array().floor().matrix() != point || point.minCoeff() < 0.0 ||
        point.maxCoeff() >= kMaxGridSide) {
      throw InputError(section.source, place_of(section, key),
                       fmt::format("[{}, {}]", point.x(), point.y()), kAllowed);
    }
    return GridCell{static_cast<int>(point.x()), static_cast<int>(point.y())};
  }
  const std::string word = read_word(section, key, kAllowed).value();
  if (word == "free") return FreeChoice{};
  if (const auto corner = corner_named(word)) return *corner;
  throw InputError(section.source, place_of(section, key), word, kAllowed);
}

}  // namespace headland
