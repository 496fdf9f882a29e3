// What pictures of grid plans show, told by their pixels.
#include "render/grid_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/convergence_chart.h"
#include "render/gl_context.h"
#include "render/gnuplot.h"
#include "render/grid_panel.h"
#include "terrains/grid_map_file.h"

namespace headland {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kSide_px = 40;  // of a cell
constexpr double kCorner_px = 10.0;
constexpr int kLevels = 2;  // of 255: rounding of colours

GridMap corner_map() { return parse_grid_map("....\n.#..\n....\n", 1.0, "drawn"); }

// Down the left side, right along the bottom, up, and back over a part of it.
const std::vector<GridCell> kThere = {{0, 2}, {0, 1}, {0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 0},
                                      {2, 1}, {2, 2}, {2, 1}, {3, 1}, {2, 1}, {2, 2}, {1, 2}};

Image painted(const GridMap& map, const std::vector<GridCell>& path) {
  const Eigen::Vector2i size(map.columns * kSide_px + 20, map.rows * kSide_px + 20);
  Typeface typeface(kFontFile, kBoldFontFile);
  const GlContext context;
  const GlFrame frame(size.x(), size.y(), colours::kPaper);
  Sheet sheet;
  draw_grid_panel(sheet, {map, {kCorner_px, kCorner_px}, kSide_px}, path);
  return frame.draw([&](const Canvas& canvas) { paint(sheet, typeface, canvas); });
}

Rgba pixel_at(const Image& image, double x_px, double y_px) {
  const std::size_t i =
      4 * (static_cast<std::size_t>(y_px) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(x_px));
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

bool alike(Rgba a, Rgba b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) <= kLevels;
}

// Near the cell's upper left corner, where no line of the path comes.
Rgba ground_of(const Image& image, const GridMap& map, const GridCell& cell) {
  constexpr double kInside = 0.12;
  return pixel_at(image, kCorner_px + (cell.column + kInside) * kSide_px,
                  kCorner_px + (map.rows - 1 - cell.row + kInside) * kSide_px);
}

TEST(GridPicture, CellsHaveTheColoursOfTheLegend) {
  const GridMap map = corner_map();
  const Image image = painted(map, kThere);
  EXPECT_TRUE(alike(ground_of(image, map, {0, 2}), colours::kFirstCell));
  EXPECT_TRUE(alike(ground_of(image, map, {1, 2}), colours::kLastCell));
  EXPECT_TRUE(alike(ground_of(image, map, {1, 1}), colours::kBlockedCell));
  EXPECT_TRUE(alike(ground_of(image, map, {2, 0}), colours::kCellTwice));
  EXPECT_TRUE(alike(ground_of(image, map, {2, 1}), colours::kCellOften));
  EXPECT_TRUE(alike(ground_of(image, map, {0, 1}), colours::kFreeCell));
  EXPECT_TRUE(alike(ground_of(image, map, {3, 2}), colours::kFreeCell));  // never visited
}

TEST(GridPicture, ThePathRunsThroughTheCentresAndBesideItselfWhereItComesAgain) {
  const GridMap map = corner_map();
  const Image image = painted(map, kThere);
  const auto at_cell = [&](double column, double row_from_top) {
    return pixel_at(image, kCorner_px + (column + 0.5) * kSide_px,
                    kCorner_px + (row_from_top + 0.5) * kSide_px);
  };
  EXPECT_TRUE(alike(at_cell(0.0, 0.75), colours::kGridPath));  // down the left side, once
  EXPECT_TRUE(alike(at_cell(0.75, 2.0), colours::kGridPath));  // along the bottom
  // Between (2, 0) and (3, 0) there and back: on either side of the middle, not on it.
  EXPECT_FALSE(alike(at_cell(2.3, 2.0), colours::kGridPath));
  EXPECT_TRUE(alike(at_cell(2.3, 2.17), colours::kGridPath));
  EXPECT_TRUE(alike(at_cell(2.3, 1.83), colours::kGridPath));
  EXPECT_FALSE(alike(at_cell(3.0, 0.5), colours::kGridPath));  // no step here
}

TEST(GridPicture, JumpsAreNotDrawnAsThePath) {
  const GridMap map = corner_map();
  const Image image = painted(map, {{0, 0}, {3, 0}});
  const Rgba middle = pixel_at(image, kCorner_px + 2.0 * kSide_px, kCorner_px + 2.5 * kSide_px);
  EXPECT_FALSE(alike(middle, colours::kGridPath));
  EXPECT_FALSE(alike(middle, colours::kFreeCell));
}

TEST(GridPicture, TakesMapsOfAnyShapeAndPlansThatAreNone) {
  for (const auto& [columns, rows] : {std::pair{1, 1}, {400, 1}, {1, 300}, {300, 200}}) {
    const GridMap map = free_grid_map(columns, rows);
    const GridFigure figure{"planner", {"refused: " + std::string(300, 'x') + " y"}, {}};
    const Image alone = draw_grid_plan(map, figure);
    const Image sheet = draw_grid_sheet(map, "map", std::vector<GridFigure>(5, figure));
    for (const Image* image : {&alone, &sheet}) {
      EXPECT_GT(image->width, 400);
      EXPECT_LT(image->width, 4096);
      EXPECT_LT(image->height, 4096);
    }
  }
}

TEST(GridPicture, SamePlanSameBytes) {
  const GridFigure figure{"TPLP", {"cost 3"}, kThere};
  EXPECT_EQ(png_of(draw_grid_plan(corner_map(), figure)),
            png_of(draw_grid_plan(corner_map(), figure)));
}

// A line of `iterations` and twice as many evaluations.
ConvergenceLine search_line(const std::string& label, const std::vector<double>& costs) {
  ConvergenceLine line;
  line.label = label;
  for (const double first : {costs[0], costs[0] + 2.0}) {
    std::vector<ConvergencePoint> run = {{0, 10, first}};
    for (std::size_t i = 1; i < costs.size(); ++i) {
      run.push_back({static_cast<int>(10 * i), static_cast<std::int64_t>(10 + 20 * i), costs[i]});
    }
    line.runs.push_back(run);
    line.iterations.push_back(100);
    line.evaluations.push_back(210);
  }
  return line;
}

TEST(ConvergenceChart, DrawsMeansAndSpreadsOfTheRuns) {
  const std::string script =
      convergence_chart_script("a map", {search_line("it's one", {40.0, 20.0, 10.0})});
  EXPECT_THAT(script, HasSubstr("title 'it''s one'"));
  // At the first iteration: mean 41 of 40 and 42, and no further than the runs themselves.
  EXPECT_THAT(script, HasSubstr("$iterations0 << EOD\n1 40 41 42\n"));
  // At the end both are the same.
  EXPECT_THAT(script, HasSubstr("\n100 10 10 10\nEOD\n"));
  EXPECT_THAT(script, HasSubstr("\n210 10 10 10\nEOD\n"));
  EXPECT_THAT(script, HasSubstr("set logscale y"));
  EXPECT_THAT(
      chart_of(script, ChartFormat::kSvg, kConvergenceChartWidth_px, kConvergenceChartHeight_px),
      HasSubstr("</svg>"));
}

TEST(ConvergenceChart, StaysLinearWhereCostsAreNear) {
  EXPECT_THAT(convergence_chart_script("a map", {search_line("one", {12.0, 11.0, 10.0})}),
              Not(HasSubstr("set logscale y")));
}

TEST(ConvergenceChart, DrawsPlannersThatDoNotSearchAndThoseThatRefused) {
  ConvergenceLine rows;
  rows.label = "rows";
  rows.runs = {{{0, 1, 30.0}}};
  rows.iterations = {0};
  rows.evaluations = {1};
  ConvergenceLine refused;
  refused.label = "refused";
  for (const auto& lines :
       {std::vector{rows, refused, search_line("one", {40.0, 20.0})}, std::vector{rows}}) {
    const std::string script = convergence_chart_script("a map", lines);
    EXPECT_THAT(script, Not(HasSubstr("title 'refused'")));
    EXPECT_THAT(
        chart_of(script, ChartFormat::kSvg, kConvergenceChartWidth_px, kConvergenceChartHeight_px),
        HasSubstr("</svg>"));
  }
}

}  // namespace
}  // namespace headland
