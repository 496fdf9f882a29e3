#include "apps/report_pictures.h"

#include <fmt/format.h>

#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {

void add_picture(const std::filesystem::path& folder, const KnownPicture& known,
                 std::vector<PagePicture>& pictures, std::vector<std::string>& missing) {
  try {
    pictures.push_back({known.name, known.title, known.alt,
                        image_of_png(read_text(folder / known.name), known.name)});
  } catch (const InputError&) {
    missing.push_back(fmt::format(
        "The picture {} is missing (the program draws it with the results).", known.name));
  }
}

std::string text_at(const nlohmann::ordered_json& json, const char* object, const char* key) {
  if (!json.is_object() || !json.contains(object)) return "";
  const nlohmann::ordered_json& inner = json.at(object);
  return inner.is_object() && inner.contains(key) && inner.at(key).is_string()
             ? inner.at(key).get<std::string>()
             : "";
}

}  // namespace headland
