#include "vehicle_models/urdf_text.h"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <mutex>
#include <sstream>
#include <vector>

#include "terrains/input_error.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!fs::is_regular_file(file) || !in) {
    throw InputError(file.string(), "", "",
                     "cannot be read; a vehicle is a folder with a vehicle.urdf and a drive.yaml");
  }
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
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
  UrdfLines lines = read_lines(text, file);
  return {parse_model(text, file), std::move(lines)};
}

}  // namespace headland
