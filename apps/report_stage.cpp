#include "apps/report_stage.h"

#include <fmt/format.h>

#include "apps/close_ups.h"
#include "apps/interrupt.h"
#include "apps/report_pictures.h"
#include "evaluate/atomic_file.h"
#include "evaluate/packed_bytes.h"
#include "evaluate/report_data.h"
#include "evaluate/results.h"
#include "render/ground_images.h"
#include "render/page_image.h"
#include "render/path_quantity.h"
#include "render/report_page.h"
#include "render/scene_file.h"

namespace headland {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kReliefSide_px = 1000;  // shading is smooth and costs most of the bytes
constexpr int kCoverageSide_px = 1600;

const KnownPicture kRunPictures[] = {
    {kViewPicture, "The driven swaths on the terrain, with the machine where it ended",
     "Perspective picture of the field: its terrain, the ground that was worked, obstacles, and "
     "the "
     "machine where the run ended"},
    {kFieldPicture, "The field from above: what was covered how often, planned and driven path",
     "Map of the field: ground worked once, twice, three times or more, and missed; the planned "
     "and the driven path, start and end"},
    {kEnergyPicture, "What every metre of the way cost the battery",
     "Map of the driven path, coloured by battery energy per metre"}};

Json image_json(const GroundImage& ground) {
  const Extent& extent = ground.extent;
  return {{"extent_m", {extent.low.x(), extent.low.y(), extent.high.x(), extent.high.y()}},
          {"url", image_url(ground.image)}};
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

ReportPage run_report(const Job& job) {
  const Stage& stage = job.stage;
  const RecordedRun recorded = read_recorded_run(job.folder, stage.field);
  const CoverageRaster coverage =
      measure_coverage(stage.field, recorded.run.footprints, job.scenario.working_width_m,
                       job.scenario.coverage_cell_m);
  std::vector<PagePicture> pictures = close_ups(job, recorded);
  std::vector<std::string> missing = recorded.missing;
  for (const KnownPicture& known : kRunPictures) {
    add_picture(job.folder, known, pictures, missing);
  }
  const std::vector<double> wh_per_m =
      quantity_along(recorded.run.samples, PathQuantity::kEnergyPerMetre);
  Json data = run_page_json({job.scenario, stage, recorded, coverage, wh_per_m}, HEADLAND_VERSION);
  data["missing"] = missing;
  const PictureScene scene{stage.field,   stage.terrain, stage.vehicle,
                           recorded.path, recorded.run,  coverage};
  data["relief"] = image_json(draw_relief(scene, kReliefSide_px));
  data["coverage"] = image_json(coverage_image(coverage, kCoverageSide_px));
  const SceneFile file = scene_file(scene);
  data["scene"] = {{"base_m", file.base_m}, {"glb", packed_bytes(file.glb)}};
  return {report_html(words_of(job, recorded.metrics), data, pictures), missing};
}

void report_stage(const Job& job) {
  std::string html;
  {
    const InterruptAtOnce at_once;
    html = run_report(job).html;
  }
  write_together(job.folder, {{kReportFile, html}});
}

}  // namespace headland
