#include "terrains/json_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {

nlohmann::ordered_json parse_json(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::ordered_json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    throw InputError(file.string(), fmt::format("line {}", line), "",
                     fmt::format("malformed JSON (character {})", error.byte));
  } catch (const nlohmann::ordered_json::exception& error) {
    // A number beyond every double; the library's text quotes it.
    throw InputError(file.string(), "", "", fmt::format("malformed JSON: {}", error.what()));
  }
}

std::string json_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace headland
