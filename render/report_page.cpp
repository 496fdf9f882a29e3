#include "render/report_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/page_image.h"
#include "render/report_assets.h"
#include "terrains/json_text.h"

namespace headland {
namespace {

constexpr char kPolicy[] =
    "default-src 'none'; img-src data: blob:; font-src data:; style-src 'unsafe-inline'; "
    "script-src 'unsafe-inline'";

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

// JSON in which no tag can begin.
std::string script_safe(std::string json) {
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at)) {
    json.replace(at, 1, "\\u003c");
  }
  return json;
}

std::string words_html(const PageWords& words) {
  std::string html = fmt::format("<header><h1>{}</h1>\n", escaped(words.title));
  if (!words.verdict.empty()) html += fmt::format("<p>Verdict: {}</p>\n", escaped(words.verdict));
  html += "<ul>\n";
  for (const std::string& line : words.lines) html += fmt::format("<li>{}</li>\n", escaped(line));
  return html + "</ul></header>\n";
}

std::string picture_html(const PagePicture& picture) {
  return fmt::format(
      "<figure data-picture=\"{}\"><img alt=\"{}\" src=\"{}\">"
      "<figcaption>{}</figcaption></figure>\n",
      escaped(picture.name), escaped(picture.alt), image_url(picture.image),
      escaped(picture.title));
}

}  // namespace

std::string report_html(const PageWords& words, const nlohmann::ordered_json& data,
                        const std::vector<PagePicture>& pictures) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main id=\"page\">\n",
      kPolicy, escaped(words.title), report_style());
  html += words_html(words);
  for (const PagePicture& picture : pictures) html += picture_html(picture);
  html += "</main>\n<script type=\"application/json\" id=\"report\">";
  html += script_safe(json_text(data));
  html += "</script>\n<script>\n";
  html += report_script();
  return html + "</script>\n</body>\n</html>\n";
}

}  // namespace headland
