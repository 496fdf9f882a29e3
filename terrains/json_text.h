// JSON files, read with the line of what is wrong and written whatever the strings hold.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace headland {

// Throws InputError as read_text does and, with the line, for malformed JSON.
nlohmann::ordered_json parse_json(const std::filesystem::path& file);

// Compact, or indented by `indent` spaces. Bytes that are not UTF-8 are replaced, numbers that are
// not finite become null.
std::string json_text(const nlohmann::ordered_json& json, int indent = -1);

}  // namespace headland
