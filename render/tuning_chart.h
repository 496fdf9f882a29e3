// What energy models tell of plans against what the plans took, and what methods save.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace headland {

struct PredictionPanel {
  std::string title;
  std::vector<std::pair<double, double>> driven_predicted_wh;
};

struct SavingBar {
  std::string label;
  double percent = 0.0;
  std::optional<double> ci95_percent;  // half width; none is drawn where it is not known
};

// Scripts for chart_of (render/gnuplot.h). Lists are not empty.
std::string prediction_chart_script(const std::string& title,
                                    const std::vector<PredictionPanel>& panels);
std::string saving_chart_script(const std::string& title, const std::vector<SavingBar>& bars);

inline constexpr int kTuningChartWidth_px = 1200;
inline constexpr int kTuningChartHeight_px = 460;

}  // namespace headland
