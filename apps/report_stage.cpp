#include "apps/report_stage.h"

#include <fmt/format.h>

#include "apps/close_ups.h"
#include "apps/compare_pictures.h"
#include "apps/interrupt.h"
#include "evaluate/atomic_file.h"
#include "evaluate/base64.h"
#include "evaluate/report_data.h"
#include "evaluate/results.h"
#include "render/ground_images.h"
#include "render/path_quantity.h"
#include "render/report_page.h"
#include "render/scene_file.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kReliefSide_px = 1000;  // shading is smooth and costs most of the bytes
constexpr int kCoverageSide_px = 1600;

struct KnownPicture {
  std::string name;
  std::string title;
  std::string alt;
};
const KnownPicture kRunPictures[] = {
    {kViewPicture, "The driven swaths on the terrain, with the machine where it ended",
     "Perspective picture of the field: its terrain, the ground that was worked, obstacles, and "
     "the "
     "machine where the run ended"},
    {kFieldPicture, "The field from above: what was covered how often, planned and driven path",
     "Map of the field: ground worked once, twice, three times or more, and missed; the planned "
     "and "
     "the driven path, start and end"},
    {kEnergyPicture, "What every metre of the way cost the battery",
     "Map of the driven path, coloured by battery energy per metre"}};

// The picture's bytes into `pictures`, or what is missing into `missing`.
void add_picture(const fs::path& folder, const KnownPicture& known,
                 std::vector<PagePicture>& pictures, std::vector<std::string>& missing) {
  try {
    pictures.push_back({known.name, known.title, known.alt, read_text(folder / known.name)});
  } catch (const InputError&) {
    missing.push_back(fmt::format(
        "The picture {} is missing (the program draws it with the results).", known.name));
  }
}

Json image_json(const GroundImage& ground) {
  const Extent& extent = ground.extent;
  return {{"extent_m", {extent.low.x(), extent.low.y(), extent.high.x(), extent.high.y()}},
          {"png", base64(png_of(ground.image))}};
}

std::string text_at(const Json& json, const char* object, const char* key) {
  if (!json.is_object() || !json.contains(object)) return "";
  const Json& inner = json.at(object);
  return inner.is_object() && inner.contains(key) && inner.at(key).is_string()
             ? inner.at(key).get<std::string>()
             : "";
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

PageWords words_of(const Job& job, const Json& metrics) {
  PageWords words;
  words.title = job.scenario.name;
  words.verdict = text_at(metrics, "verdict", "grade");
  if (!words.verdict.empty()) {
    for (const Json& reason : metrics["verdict"]["reasons"]) {
      if (reason.contains("text")) words.lines.push_back(reason["text"].get<std::string>());
    }
  }
  return words;
}

}  // namespace

std::string run_report(const Job& job) {
  const Stage& stage = job.stage;
  RecordedRun recorded = read_recorded_run(job.folder, stage.field);
  const CoverageRaster coverage =
      measure_coverage(stage.field, recorded.run.footprints, job.scenario.working_width_m,
                       job.scenario.coverage_cell_m);
  std::vector<PagePicture> pictures = close_ups(job, recorded);
  std::vector<std::string> missing_pictures;
  for (const KnownPicture& known : kRunPictures) {
    add_picture(job.folder, known, pictures, missing_pictures);
  }
  const std::vector<double> wh_per_m =
      quantity_along(recorded.run.samples, PathQuantity::kEnergyPerMetre);
  Json data = run_page_json({job.scenario, stage, recorded, coverage, wh_per_m}, HEADLAND_VERSION);
  for (const std::string& missing : missing_pictures) data["missing"].push_back(missing);
  const PictureScene scene{stage.field,   stage.terrain, stage.vehicle,
                           recorded.path, recorded.run,  coverage};
  data["relief"] = image_json(draw_relief(scene, kReliefSide_px));
  data["coverage"] = image_json(coverage_image(coverage, kCoverageSide_px));
  const SceneFile file = scene_file(scene);
  data["scene"] = {{"base_m", file.base_m}, {"glb", base64(file.glb)}};
  return report_html(words_of(job, recorded.metrics), data, pictures);
}

void report_stage(const Job& job) {
  std::string html;
  {
    const InterruptAtOnce at_once;
    html = run_report(job);
  }
  write_together(job.folder, {{kReportFile, html}});
}

std::string comparison_report(const fs::path& folder) {
  const fs::path file = folder / kComparisonFile;
  Json data = {{"kind", "compare"}, {"version", HEADLAND_VERSION}, {"missing", Json::array()}};
  data["compare"] = parse_json(file);
  const Json& compare = data["compare"];
  for (const char* needed : {"comparison", "results", "runs"}) {
    if (compare.is_object() && compare.contains(needed)) continue;
    throw InputError(file.string(), needed, "",
                     "the key is missing: 'headland compare' writes such a file");
  }
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
  return report_html({"Comparison: " + text_at(compare, "comparison", "name"), "", {}}, data,
                     pictures);
}

}  // namespace headland
