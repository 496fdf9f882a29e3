#include "evaluate/comparison_fields.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "evaluate/comparison_maps.h"
#include "evaluate/scenario_parts.h"
#include "planner/region_generator.h"
#include "terrains/field_source.h"
#include "terrains/input_error.h"
#include "terrains/terrain_source.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kFieldSources = {"file", "boundary", "generator"};
const std::vector<std::string> kFieldsKeys = {"name",      "file",  "layer",  "crs",   "boundary",
                                              "holes",     "entry", "count",  "parts", "start",
                                              "generator", "end",   "terrain"};
const std::vector<std::string> kRegionKeys = {"parts", "holes", "area_m2", "seed"};
const std::vector<std::string> kPartsKeys = {"width_m",       "method",      "slice_deg",
                                             "least_area_m2", "small_parts", "merge"};
constexpr NumberRange kPartsWidth{0.05, 1000.0};
constexpr NumberRange kPartsArea{0.0, 1e12};
constexpr int kMostRegionHoles = 500;
// Of a start or an end from the field: further off is a slip of the pen.
constexpr double kFarthestPlace_m = 1000.0;

void refuse_key_without(const YamlSection& section, std::string_view key, std::string_view other) {
  if (!has_key(section, key) || has_key(section, other)) return;
  throw InputError(section.source, place_of(section, key), "", fmt::format("only with {}", other));
}

Field read_given_field(const YamlSection& section) {
  FieldSource source;
  source.file = read_file_name(section, "file", fs::absolute(section.source).parent_path());
  source.layer = read_word(section, "layer").value_or("");
  source.crs = read_crs(section);
  source.boundary = read_points(section, "boundary").value_or(Ring{});
  source.holes = read_point_lists(section, "holes").value_or(std::vector<Ring>{});
  source.entry = read_point(section, "entry");
  source.entry_place = place_of(section, "entry");
  return read_field(source, section.source);
}

std::vector<ComparedMap> made_up_fields(const YamlSection& entry, const YamlSection& section,
                                        std::uint64_t seed) {
  refuse_unknown_keys(section, kRegionKeys);
  RegionRecipe recipe;
  recipe.parts = read_count(section, "parts", 1, kMostMadeUpParts).value_or(recipe.parts);
  recipe.holes = read_count(section, "holes", 0, kMostRegionHoles).value_or(recipe.holes);
  recipe.area_m2 = read_number(section, "area_m2", {1.0, 1e10}).value_or(recipe.area_m2);
  recipe.seed = read_whole_number(section, "seed").value_or(seed);
  const std::string name = read_word(entry, "name").value_or(fmt::format("{}_parts", recipe.parts));
  const auto count = read_count(entry, "count", 1, kMostMapsOfARecipe);
  std::vector<ComparedMap> fields;
  for (int i = 0; i < count.value_or(1); ++i, ++recipe.seed) {
    ComparedMap& field = fields.emplace_back();
    field.name = count ? fmt::format("{}_{}", name, i + 1) : name;
    field.region.emplace().field =
        made_up_region(recipe, entry.source + ": " + place_of_itself(section));
  }
  return fields;
}

std::optional<Eigen::Vector2d> place_in(const std::optional<GivenPlace>& given, const Field& field,
                                        const YamlSection& section, std::string_view key) {
  if (!given || std::holds_alternative<FreeChoice>(*given)) return std::nullopt;
  if (const auto* p_W = std::get_if<Eigen::Vector2d>(&*given)) {
    Eigen::AlignedBox2d near;
    for (const Eigen::Vector2d& corner_W : field.boundary) near.extend(corner_W);
    if (near.exteriorDistance(*p_W) <= kFarthestPlace_m) return *p_W;
    throw InputError(section.source, place_of(section, key),
                     fmt::format("[{:g}, {:g}]", p_W->x(), p_W->y()),
                     fmt::format("within {:g} m of the field", kFarthestPlace_m));
  }
  if (std::holds_alternative<FieldEntry>(*given)) {
    if (field.entry_W) return field.entry_W;
    throw InputError(section.source, place_of(section, key), "entry",
                     "this field has no entry; a point, a corner or free");
  }
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p_W : field.boundary) box.extend(p_W);
  const MapCorner corner = std::get<MapCorner>(*given);
  const bool east = corner == MapCorner::kNorthEast || corner == MapCorner::kSouthEast;
  const bool north = corner == MapCorner::kNorthWest || corner == MapCorner::kNorthEast;
  return Eigen::Vector2d(east ? box.max().x() : box.min().x(),
                         north ? box.max().y() : box.min().y());
}

}  // namespace

std::optional<GivenPlace> read_place(const YamlSection& section, std::string_view key) {
  const YAML::Node mapping = section.node;
  const YAML::Node node = mapping[std::string(key)];
  if (!node.IsDefined()) return std::nullopt;
  if (node.IsSequence()) return read_point(section, key).value();
  constexpr const char* kAllowed =
      "a point [x, y] in metres, free, entry, or a corner: north_west, north_east, south_west, "
      "south_east";
  const std::string word = read_word(section, key, kAllowed).value();
  if (word == "free") return FreeChoice{};
  if (word == "entry") return FieldEntry{};
  if (const auto corner = corner_named(word)) return *corner;
  throw InputError(section.source, place_of(section, key), word, kAllowed);
}

PartsOptions read_parts_options(const YamlSection& section, const PartsOptions& defaults) {
  PartsOptions options = defaults;
  const auto parts = read_section(section, "parts");
  if (!parts) return options;
  refuse_unknown_keys(*parts, kPartsKeys);
  options.width_m = read_number(*parts, "width_m", kPartsWidth).value_or(options.width_m);
  options.decomposition =
      read_choice<Decomposition>(*parts, "method", options.decomposition,
                                 {{"convex", Decomposition::kConvex},
                                  {"trapezoidal", Decomposition::kTrapezoidal},
                                  {"boustrophedon", Decomposition::kBoustrophedon}});
  if (const auto slice_deg = read_number(*parts, "slice_deg", {0.0, 360.0})) {
    options.slice_rad = std::fmod(*slice_deg, 180.0) * std::numbers::pi / 180.0;
  }
  options.least_m2 = read_number(*parts, "least_area_m2", kPartsArea).value_or(options.least_m2);
  options.small =
      read_choice<SmallParts>(*parts, "small_parts", options.small,
                              {{"drop", SmallParts::kDrop}, {"merge", SmallParts::kMerge}});
  options.merge = read_flag(*parts, "merge").value_or(options.merge);
  return options;
}

std::vector<ComparedMap> read_compared_fields(const YamlSection& section,
                                              const FieldDefaults& defaults, std::uint64_t seed) {
  refuse_unknown_keys(section, kFieldsKeys);
  const auto sources =
      std::ranges::count_if(kFieldSources, [&](const auto& key) { return has_key(section, key); });
  if (sources != 1) {
    throw InputError(
        section.source, place_of_itself(section), "",
        fmt::format("one of {} is needed, and no two", fmt::join(kFieldSources, ", ")));
  }
  refuse_key_without(section, "count", "generator");
  refuse_key_without(section, "layer", "file");
  refuse_key_without(section, "holes", "boundary");
  const auto generator = read_section(section, "generator");
  std::vector<ComparedMap> fields;
  if (generator) {
    for (const char* key : {"crs", "entry"}) refuse_key_without(section, key, "file or boundary");
    fields = made_up_fields(section, *generator, seed);
  } else {
    ComparedMap& field = fields.emplace_back();
    field.region.emplace().field = read_given_field(section);
    const fs::path file = read_word(section, "file").value_or("field");
    field.name = read_word(section, "name").value_or(file.stem().string());
  }
  const auto own_start = read_place(section, "start");
  const auto own_end = read_place(section, "end");
  const PartsOptions options = read_parts_options(section, defaults.parts);
  Scenario ground;
  ground.seed = seed;
  if (has_key(section, "terrain")) {
    read_terrain_source({section.source, "", section.node},
                        fs::absolute(section.source).parent_path(), ground);
  }
  if (!(options.width_m > 0.0)) {
    throw InputError(section.source, place_of(section, "parts"), "",
                     "parts.width_m, the width of a swath, is needed here or at the top");
  }
  for (ComparedMap& field : fields) {
    ComparedRegion& region = *field.region;
    region.options = options;
    if (has_key(section, "terrain")) {
      region.terrain = read_terrain(
          ground.terrain, region.field,
          fmt::format("{}: {} '{}'", section.source, place_of(section, "terrain"), field.name));
    }
    region.start_W =
        place_in(own_start ? own_start : defaults.start, region.field, section, "start");
    region.end_W = place_in(own_end ? own_end : defaults.end, region.field, section, "end");
    divide(region,
           fmt::format("{}: {} '{}'", section.source, place_of_itself(section), field.name));
  }
  return fields;
}

std::vector<std::string> compared_field_key_paths() {
  std::vector<std::string> paths;
  const auto add = [&](const std::string& prefix, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) paths.push_back(prefix + key);
  };
  add("fields.", kFieldsKeys);
  add("fields.generator.", kRegionKeys);
  add("parts.", kPartsKeys);
  return paths;
}

}  // namespace headland
