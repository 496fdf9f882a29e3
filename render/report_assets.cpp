#include "render/report_assets.h"

// The assembler takes the files in as they are; CMake names them and rebuilds when they change.
#define HEADLAND_EMBED(symbol, file)    \
  __asm__(                              \
      ".pushsection .rodata\n"          \
      ".global " symbol                 \
      "_begin\n"                        \
      ".global " symbol "_end\n" symbol \
      "_begin:\n"                       \
      ".incbin \"" file "\"\n" symbol   \
      "_end:\n"                         \
      ".byte 0\n"                       \
      ".popsection\n")

HEADLAND_EMBED("headland_report_script", HEADLAND_REPORT_BUNDLE "/report.js");
HEADLAND_EMBED("headland_report_style", HEADLAND_REPORT_BUNDLE "/report.css");

extern "C" {
extern const char headland_report_script_begin[];
extern const char headland_report_script_end[];
extern const char headland_report_style_begin[];
extern const char headland_report_style_end[];
}

namespace headland {

std::string_view report_script() {
  return {headland_report_script_begin, headland_report_script_end};
}

std::string_view report_style() { return {headland_report_style_begin, headland_report_style_end}; }

}  // namespace headland
