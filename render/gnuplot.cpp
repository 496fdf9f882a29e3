#include "render/gnuplot.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "render/called_program.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

// A new folder for one chart, gone with all in it at the end.
struct ScratchFolder {
  fs::path path;

  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "headland-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw InputError(name, "", "", "a temporary folder cannot be made here");
    }
    path = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
};

}  // namespace

void require_gnuplot() { require_program("gnuplot", "draws the charts", "gnuplot-nox"); }

std::string gnuplot_text(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += c;
  }
  return out + "'";
}

std::string chart_of(const std::string& script, ChartFormat format, int width_px, int height_px) {
  require_gnuplot();
  const ScratchFolder scratch;
  const fs::path file = scratch.path / "chart";
  const std::string terminal =
      format == ChartFormat::kSvg
          ? fmt::format("svg size {},{} font 'DejaVu Sans,12' background '#fcfcfa'", width_px,
                        height_px)
          : fmt::format("pngcairo size {},{} font 'DejaVu Sans,11' background '#fcfcfa'", width_px,
                        height_px);
  const std::string all = fmt::format("set terminal {} noenhanced\nset output {}\n{}\nset output\n",
                                      terminal, gnuplot_text(file.string()), script);
  const BrokenPipesIgnored ignored;
  // A command without any word of the user's.
  FILE* gnuplot = ::popen("gnuplot 2>/dev/null", "w");
  if (gnuplot == nullptr) throw InputError("gnuplot", "", "", "cannot be started");
  std::fwrite(all.data(), 1, all.size(), gnuplot);
  const int status = ::pclose(gnuplot);
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (status != 0 || bytes.empty()) {
    throw InputError("gnuplot", "", fmt::format("exit status {}", status),
                     "could not draw a chart");
  }
  return bytes;
}

}  // namespace headland
