// Pictures and words that a page takes from a results folder.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/report_page.h"

namespace headland {

struct ReportPage {
  std::string html;
  std::vector<std::string> missing;  // what the page says that it lacks, one sentence each
};

struct KnownPicture {
  std::string name;   // of the file in the folder
  std::string title;  // caption
  std::string alt;    // what is to be seen, for those who cannot
};

// The picture's bytes into `pictures`, or that it is missing into `missing`.
void add_picture(const std::filesystem::path& folder, const KnownPicture& known,
                 std::vector<PagePicture>& pictures, std::vector<std::string>& missing);

// The text json[object][key]; empty when there is none.
std::string text_at(const nlohmann::ordered_json& json, const char* object, const char* key);

}  // namespace headland
