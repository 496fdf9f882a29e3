// report.html: one file that holds everything it shows.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/image.h"
#include "render/relief.h"

namespace headland {

struct PagePicture {
  std::string name;   // "field.png"
  std::string title;  // caption
  std::string alt;    // what is to be seen, for those who cannot
  Image image;
};

// What the page says by itself, before and without its script.
struct PageWords {
  std::string title;
  std::string verdict;  // "PASS"; may be empty
  std::vector<std::string> lines;
};

// The page: the words and pictures as plain HTML, then `data` and the script of web/, which makes
// of all this what people see. Nothing is loaded from elsewhere, and the page forbids it. Same
// arguments, same bytes.
std::string report_html(const PageWords& words, const nlohmann::ordered_json& data,
                        const std::vector<PagePicture>& pictures);

}  // namespace headland
