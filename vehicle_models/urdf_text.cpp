#include "vehicle_models/urdf_text.h"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string_view>
#include <system_error>
#include <vector>

#include "terrains/input_error.h"
#include "terrains/input_file.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw InputError(file.string(), "", "",
                     "cannot be read; a vehicle is a folder with a vehicle.urdf and a drive.yaml");
  }
  return read_text(file);
}

// Both parsers call themselves for what lies within, with elements and with links.
constexpr int kMaxNesting = 256;
constexpr int kMaxLinks = 2000;

// Past the end of what starts with the '<' at `at`; of an element's tag past the '>' that is not
// within quotes.
std::size_t after_markup(std::string_view text, std::size_t at, bool element) {
  const auto past = [&](std::string_view end) {
    const std::size_t found = text.find(end, at);
    return found == std::string_view::npos ? text.size() : found + end.size();
  };
  if (text.substr(at).starts_with("<!--")) return past("-->");
  if (text.substr(at).starts_with("<![CDATA[")) return past("]]>");
  if (!element) return past(">");
  char quote = 0;
  for (++at; at < text.size() && (quote != 0 || text[at] != '>'); ++at) {
    if (quote == 0 && (text[at] == '"' || text[at] == '\'')) {
      quote = text[at];
    } else if (text[at] == quote) {
      quote = 0;
    }
  }
  return std::min(at + 1, text.size());
}

bool starts_name(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || (c & 0x80) != 0;
}

// Looks at the tags alone, before anything that would go as deep as the file does.
void check_extent(std::string_view text, const fs::path& file) {
  const auto refuse = [&](std::size_t at, const std::string& allowed) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(at);
    throw InputError(file.string(), fmt::format("line {}", 1 + std::count(text.begin(), end, '\n')),
                     "", allowed);
  };
  int depth = 0;
  int links = 0;
  for (std::size_t at = text.find('<'); at < text.size();) {
    const char first = at + 1 < text.size() ? text[at + 1] : '\0';
    const bool element = starts_name(first);
    const std::size_t end = after_markup(text, at, element);
    if (first == '/') {
      depth = std::max(0, depth - 1);
    } else if (element && text[end - 2] != '/' && ++depth > kMaxNesting) {
      refuse(at, fmt::format("elements lie in each other deeper than {} levels", kMaxNesting));
    }
    if (text.substr(at).starts_with("<link") && ++links > kMaxLinks) {
      refuse(at, fmt::format("more than {} links", kMaxLinks));
    }
    at = text.find('<', end);
  }
}

UrdfLines read_lines(const std::string& text, const fs::path& file) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  if (document.Error()) {
    throw InputError(file.string(), fmt::format("line {}", std::max(1, document.ErrorRow())), "",
                     fmt::format("malformed XML: {}", document.ErrorDesc()));
  }
  const TiXmlElement* root = document.RootElement();
  if (root == nullptr || root->ValueStr() != "robot") {
    throw InputError(file.string(), fmt::format("line {}", root == nullptr ? 1 : root->Row()), "",
                     "no URDF: the file must hold one <robot>");
  }
  UrdfLines lines;
  for (const auto* part = root->FirstChildElement(); part != nullptr;
       part = part->NextSiblingElement()) {
    if (const char* name = part->Attribute("name"); name != nullptr) {
      lines.line.try_emplace({part->ValueStr(), name}, part->Row());
    }
  }
  return lines;
}

// Keeps what urdfdom would print.
struct Complaints : console_bridge::OutputHandler {
  std::vector<std::string> lines;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level == console_bridge::CONSOLE_BRIDGE_LOG_ERROR) lines.push_back(text);
  }
};

urdf::ModelInterfaceSharedPtr parse_model(const std::string& text, const fs::path& file) {
  // The console's handler is one for the whole process.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  Complaints complaints;
  console_bridge::useOutputHandler(&complaints);
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(text);
  } catch (const std::exception& error) {
    complaints.lines.emplace_back(error.what());
  }
  console_bridge::restorePreviousOutputHandler();
  if (model == nullptr || !complaints.lines.empty()) {
    throw InputError(file.string(), "", "",
                     fmt::format("no valid URDF: {}", fmt::join(complaints.lines, "; ")));
  }
  return model;
}

}  // namespace

std::string UrdfLines::place(const std::string& kind, const std::string& name) const {
  const auto found = line.find({kind, name});
  const std::string what = fmt::format("{} '{}'", kind, name);
  return found == line.end() ? what : fmt::format("line {}: {}", found->second, what);
}

UrdfText read_urdf(const fs::path& file) {
  const std::string text = text_of(file);
  check_extent(text, file);
  UrdfLines lines = read_lines(text, file);
  return {parse_model(text, file), std::move(lines)};
}

}  // namespace headland
