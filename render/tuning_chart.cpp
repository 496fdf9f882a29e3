#include "render/tuning_chart.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/gnuplot.h"

namespace headland {

std::string prediction_chart_script(const std::string& title,
                                    const std::vector<PredictionPanel>& panels) {
  double most = 0.0;
  std::string text;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    text += fmt::format("$plans{} << EOD\n", i);
    for (const auto& [driven, predicted] : panels[i].driven_predicted_wh) {
      text += fmt::format("{:.6g} {:.6g}\n", driven, predicted);
      most = std::max({most, driven, predicted});
    }
    text += "EOD\n";
  }
  constexpr double kAir = 1.05;
  text += fmt::format(
      "set multiplot layout 1,{} title {} font 'DejaVu Sans Bold,14'\n"
      "set grid lt 1 lw 1 lc rgb '#d8d8d8'\nset border 3\nset tics nomirror\nunset key\n"
      "set size square\nset xtics rotate by -40\nset xrange [0:{:.6g}]\nset yrange [0:{:.6g}]\n"
      "set xlabel 'driven [Wh]'\n",
      panels.size(), gnuplot_text(title), kAir * most, kAir * most);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    text += fmt::format(
        "set title {}\nset ylabel {}\nplot x with lines lw 1 lc rgb '#888888', $plans{} using "
        "1:2 with points pt 7 ps 0.5 lc rgb '#0072b2'\n",
        gnuplot_text(panels[i].title), i == 0 ? "'predicted [Wh]'" : "''", i);
  }
  return text + "unset multiplot\n";
}

std::string saving_chart_script(const std::string& title, const std::vector<SavingBar>& bars) {
  std::string data = "$savings << EOD\n";
  std::string names;
  // From the top down.
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const std::size_t y = bars.size() - 1 - i;
    const std::optional<double>& ci95 = bars[i].ci95_percent;
    data += fmt::format("{} {:.6g} {}\n", y, bars[i].percent,
                        ci95 ? fmt::format("{:.6g}", *ci95) : "NaN");
    names += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_text(bars[i].label), y);
  }
  return data + "EOD\n" +
         fmt::format(
             "set title {} font 'DejaVu Sans Bold,14'\nset grid xtics lt 1 lw 1 lc rgb '#d8d8d8'\n"
             "set border 3\nset tics nomirror\nunset key\nset ytics ({})\n"
             "set yrange [-0.6:{}]\nset xlabel 'energy saved [%], mean and 95 % interval'\n"
             "set arrow from 0, graph 0 to 0, graph 1 nohead lw 1.5 lc rgb '#444444'\n"
             "plot $savings using 2:1 with points pt 7 ps 1 lc rgb '#0072b2', "
             "$savings using 2:1:3 with xerrorbars pt 7 ps 1 lw 2 lc rgb '#0072b2'\n",
             gnuplot_text(title), names, static_cast<double>(bars.size()) - 0.4);
}

}  // namespace headland
