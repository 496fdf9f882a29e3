// Draft by ASABE D497.7 against its printed example and its own form, and how a drive.yaml gives
// it.
#include "vehicle_models/draft.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/vehicle_models/changed_vehicle.h"

namespace headland {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kKmh = 1.0 / 3.6;

Implement tilling(const std::string& tool, int tools, double depth_cm, double width_m = 3.0) {
  const auto row = std::ranges::find(d497_tools(), tool, &D497Tool::name);
  EXPECT_NE(row, d497_tools().end()) << tool;
  Implement implement;
  implement.working_width_m = width_m;
  implement.tillage = TillageDraft{row->a, row->b, row->c, tools, depth_cm, row->texture_factor};
  return implement;
}

// 13.7 m chisel plough of 45 tools, 15 cm deep at 10 km/h with Fi 0.7: 68 513 N.
TEST(Draft, GivesTheStandardsChiselPlough) {
  Implement plough = tilling("chisel_plough", 45, 15.0, 13.7);
  plough.tillage->texture_factor[static_cast<std::size_t>(SoilTexture::kMedium)] = 0.7;
  EXPECT_NEAR(draft_n(plough, SoilTexture::kMedium, 10.0 * kKmh), 68513.0,
              0.6);  // as rounded there
}

TEST(Draft, GoesWithWidthToolsDepthSpeedAndTexture) {
  for (const D497Tool& row : d497_tools()) {
    const Implement one = tilling(std::string(row.name), row.per_tool ? 4 : 0, 10.0);
    const auto at = [&](SoilTexture texture, double kmh) {
      return draft_n(one, texture, kmh * kKmh);
    };
    EXPECT_NEAR(at(SoilTexture::kFine, 0.0), row.a * (row.per_tool ? 4.0 : 3.0) * 10.0, 1e-9);
    double slower_n = 0.0;
    for (const double kmh : {0.0, 2.0, 4.0, 8.0, 12.0}) {
      const double here_n = at(SoilTexture::kFine, kmh);
      EXPECT_GE(here_n, slower_n) << row.name;
      EXPECT_EQ(here_n, at(SoilTexture::kFine, -kmh)) << row.name;
      EXPECT_LE(at(SoilTexture::kMedium, kmh), here_n) << row.name;
      EXPECT_LE(at(SoilTexture::kCoarse, kmh), at(SoilTexture::kMedium, kmh)) << row.name;
      slower_n = here_n;
    }
    EXPECT_EQ(slower_n > at(SoilTexture::kFine, 0.0), row.b + row.c > 0.0) << row.name;
    if (row.at_any_depth) continue;
    Implement deeper = one;
    deeper.tillage->depth_cm = 20.0;
    EXPECT_NEAR(draft_n(deeper, SoilTexture::kFine, 2.0),
                2.0 * draft_n(one, SoilTexture::kFine, 2.0), 1e-9);
  }
}

TEST(Draft, PerMetreOfWidthHoldsAtAnySpeedOnAnySoil) {
  Implement weeder;
  weeder.working_width_m = 9.0;
  weeder.draft_n_per_m = 300.0;
  for (const SoilTexture texture : {SoilTexture::kFine, SoilTexture::kCoarse}) {
    EXPECT_EQ(draft_n(weeder, texture, 0.5), 2700.0);
    EXPECT_EQ(draft_n(weeder, texture, 3.0), 2700.0);
  }
}

// The plain vehicle with a section `draft` in place of draft_n_per_m.
std::string with_draft(const std::string& section, bool keep_per_metre = false) {
  const ChangedVehicle changed("drive.yaml", "\ndriver:\n", section + "\ndriver:\n");
  if (!keep_per_metre) {
    const std::filesystem::path file = std::filesystem::path(changed.folder()) / "drive.yaml";
    std::ifstream in(file);
    std::stringstream kept;
    for (std::string line; std::getline(in, line);) {
      if (line.find("draft_n_per_m") == std::string::npos) kept << line << '\n';
    }
    in.close();
    std::ofstream(file) << kept.str();
  }
  return load_message(changed.folder());
}

const std::string kDepth = "  depth_cm: {value: 1, source: \"assumed\"}\n";

TEST(Draft, IsReadByToolOrByCoefficients) {
  EXPECT_EQ(with_draft("\ndraft:\n  tool: sweep_plough\n" + kDepth), "");
  EXPECT_EQ(with_draft("\ndraft:\n  a: {value: 40, source: \"assumed\"}\n" + kDepth), "");
}

TEST(Draft, IsRefusedWhereItIsTwofoldOrMissing) {
  EXPECT_THAT(with_draft(""), AllOf(HasSubstr("implement.draft_n_per_m"), HasSubstr("missing key"),
                                    HasSubstr("'draft'")));
  EXPECT_THAT(with_draft("\ndraft:\n  tool: sweep_plough\n" + kDepth, true),
              AllOf(HasSubstr("implement.draft_n_per_m"), HasSubstr("only one of")));
  EXPECT_THAT(with_draft("\ndraft:\n" + kDepth),
              AllOf(HasSubstr("draft.a"), HasSubstr("or a 'tool'")));
  EXPECT_THAT(
      with_draft("\ndraft:\n  tool: sweep_plough\n  b: {value: 1, source: \"a\"}\n" + kDepth),
      AllOf(HasSubstr("draft.b"), HasSubstr("row of the tool")));
  EXPECT_THAT(with_draft("\ndraft:\n  tool: chisel_plough\n" + kDepth),
              AllOf(HasSubstr("draft.tools"), HasSubstr("draws per tool")));
  EXPECT_THAT(
      with_draft("\ndraft:\n  tool: sweep_plough\n  tools: {value: 3, source: \"a\"}\n" + kDepth),
      AllOf(HasSubstr("draft.tools"), HasSubstr("per metre")));
  EXPECT_THAT(with_draft("\ndraft:\n  tool: row_planter\n  tools: {value: 4, source: \"a\"}\n"
                         "  depth_cm: {value: 4, source: \"assumed\"}\n"),
              AllOf(HasSubstr("draft.depth_cm"), HasSubstr("'4'"), HasSubstr("at any depth")));
  EXPECT_THAT(with_draft("\ndraft:\n  tool: plough\n" + kDepth),
              AllOf(HasSubstr("draft.tool: 'plough'"), HasSubstr("mouldboard_plough")));
  EXPECT_THAT(with_draft("\ndraft:\n  tool: mouldboard_plough\n"
                         "  depth_cm: {value: 25, source: \"assumed\"}\n"),
              AllOf(HasSubstr("draft.depth_cm: '25'"), HasSubstr("the motor pulls")));
}

TEST(Draft, ShaftPowerAddsUpOverTheWidth) {
  Implement mower;
  mower.working_width_m = 3.0;
  mower.shaft_power_w = 500.0;
  mower.shaft_power_w_per_m = 5000.0;
  EXPECT_EQ(shaft_power_w(mower), 15500.0);
}

}  // namespace
}  // namespace headland
