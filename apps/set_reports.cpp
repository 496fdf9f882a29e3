#include "apps/set_reports.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "apps/compare_pictures.h"
#include "apps/report_pictures.h"
#include "apps/tune_pictures.h"
#include "evaluate/tuning_file.h"
#include "render/report_page.h"
#include "terrains/input_error.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// What a page of this kind shows: the file that the command of that name wrote, under its name.
Json page_data(const char* kind, const fs::path& file, std::initializer_list<const char*> keys) {
  Json data = {{"kind", kind}, {"version", HEADLAND_VERSION}, {"missing", Json::array()}};
  data[kind] = parse_json(file);
  for (const char* needed : keys) {
    if (data[kind].is_object() && data[kind].contains(needed)) continue;
    throw InputError(file.string(), needed, "",
                     fmt::format("the key is missing: 'headland {}' writes such a file", kind));
  }
  return data;
}

std::vector<std::string> map_names(const Json& compare) {
  std::vector<std::string> names;
  const Json& comparison = compare["comparison"];
  const char* const list = comparison.contains("fields") ? "fields" : "maps";
  if (!comparison.contains(list)) return names;
  for (const Json& map : comparison[list]) {
    if (map.is_object() && map.contains("name") && map["name"].is_string()) {
      names.push_back(map["name"].get<std::string>());
    }
  }
  return names;
}

}  // namespace

ReportPage comparison_report(const fs::path& folder) {
  Json data = page_data("compare", folder / kComparisonFile, {"comparison", "results", "runs"});
  const Json& compare = data["compare"];
  std::vector<PagePicture> pictures;
  std::vector<std::string> missing;
  for (const std::string& map : map_names(compare)) {
    const std::string name = plans_picture_name(map);
    const std::string title = fmt::format("Best plans on {}", map);
    const std::string alt = fmt::format(
        "The best plan of every planner on {}, side by side: what is covered, in which order", map);
    add_picture(folder, {name, title, alt}, pictures, missing);
  }
  for (const std::string& picture : missing) data["missing"].push_back(picture);
  return {report_html({"Comparison: " + text_at(compare, "comparison", "name"), "", {}}, data,
                      pictures),
          missing};
}

ReportPage tuning_report(const fs::path& folder) {
  Json data = page_data("tune", folder / kTuningFile,
                        {"name", "training", "held_out", "forms", "methods", "held_out_plans"});
  const Json& tune = data["tune"];
  std::vector<PagePicture> pictures;
  std::vector<std::string> missing;
  const auto drawn = [&tune](const std::string& name) {
    const Json& names = tune.contains("pictures") ? tune["pictures"] : Json::array();
    return std::find(names.begin(), names.end(), Json(name)) != names.end();
  };
  for (const auto& [name, most] :
       {std::pair{kMostSavedPicture, "most"}, {kLeastSavedPicture, "least"}}) {
    if (!drawn(name)) continue;
    add_picture(folder,
                {name,
                 fmt::format("The held-out field where measured costs save {} over the weights of "
                             "Wu et al.: how every method plans it",
                             most),
                 "Plans of one field side by side, one a method: the way over its cells from start "
                 "to end, and below each what it took"},
                pictures, missing);
  }
  for (const std::string& picture : missing) data["missing"].push_back(picture);
  const std::string name = tune["name"].is_string() ? tune["name"].get<std::string>() : "";
  return {report_html({"Tuning: " + name, "", {}}, data, pictures), missing};
}

}  // namespace headland
