#include <fmt/format.h>

#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "terrains/task_data.h"

namespace headland {
namespace {

constexpr std::size_t kLongestName = 32;
constexpr double kMillimetresPerMetre = 1e3;
constexpr int kBothEnds = 1;
constexpr int kNoExtension = 4;
constexpr int kDesktopGenerated = 16;

template <typename Value>
void set(pugi::xml_node node, const char* attribute, const Value& value) {
  node.append_attribute(attribute).set_value(value);
}

// Its first characters, none of them cut in two; XML has no control characters.
std::string shortened(std::string name) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<unsigned char>(name[i]);
    if (byte < ' ') name[i] = ' ';
    const bool begins = (byte & 0xC0U) != 0x80U;
    if (begins && ++characters > kLongestName) return name.substr(0, i);
  }
  return name;
}

void set_name(pugi::xml_node node, const char* attribute, const std::string& name) {
  if (!name.empty()) set(node, attribute, shortened(name).c_str());
}

void append_point(pugi::xml_node parent, TaskPointType type, const std::string& name,
                  const Eigen::Vector2d& lon_lat_deg) {
  const pugi::xml_node node = parent.append_child("PNT");
  set(node, "A", static_cast<int>(type));
  set_name(node, "B", name);
  set(node, "C", fmt::format("{:.10f}", lon_lat_deg.y()).c_str());
  set(node, "D", fmt::format("{:.10f}", lon_lat_deg.x()).c_str());
}

// What a point of a line is, from its place among them.
TaskPointType type_in_line(TaskLineType line, std::size_t index, std::size_t count) {
  if (line != TaskLineType::kGuidance) return TaskPointType::kOther;
  if (index == 0) return TaskPointType::kGuidanceA;
  return index + 1 == count ? TaskPointType::kGuidanceB : TaskPointType::kGuidancePoint;
}

void append_line(pugi::xml_node parent, const TaskLine& line) {
  const pugi::xml_node node = parent.append_child("LSG");
  set(node, "A", static_cast<int>(line.type));
  set_name(node, "B", line.name);
  if (line.width_m > 0.0) {
    set(node, "C", static_cast<unsigned>(std::lround(kMillimetresPerMetre * line.width_m)));
  }
  const std::size_t count = line.lon_lat_deg.size();
  for (std::size_t i = 0; i < count; ++i) {
    append_point(node, type_in_line(line.type, i, count), "", line.lon_lat_deg[i]);
  }
  if (line.type == TaskLineType::kExterior || line.type == TaskLineType::kInterior) {
    append_point(node, TaskPointType::kOther, "", line.lon_lat_deg.front());
  }
}

void append_polygon(pugi::xml_node parent, const TaskPolygon& polygon) {
  const pugi::xml_node node = parent.append_child("PLN");
  set(node, "A", static_cast<int>(polygon.type));
  set_name(node, "B", polygon.name);
  for (const TaskLine& ring : polygon.rings) append_line(node, ring);
}

void append_pattern(pugi::xml_node parent, const GuidancePattern& pattern, int id) {
  const pugi::xml_node node = parent.append_child("GPN");
  set(node, "A", fmt::format("GPN{}", id).c_str());
  set_name(node, "B", pattern.name);
  set(node, "C", static_cast<int>(pattern.kind));
  set(node, "E", static_cast<int>(pattern.repeats ? Propagation::kBoth : Propagation::kNone));
  set(node, "F", pattern.repeats ? kBothEnds : kNoExtension);
  set(node, "I", kDesktopGenerated);
  append_line(node, pattern.line);
}

}  // namespace

std::string task_data_text(const TaskData& data, const std::string& version) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node root = document.append_child("ISO11783_TaskData");
  set(root, "VersionMajor", 4);
  set(root, "VersionMinor", 3);
  set(root, "ManagementSoftwareManufacturer", "headland");
  set(root, "ManagementSoftwareVersion", version.c_str());
  set(root, "DataTransferOrigin", 1);
  int partfields = 0;
  int groups = 0;
  int patterns = 0;
  for (const Partfield& partfield : data.partfields) {
    pugi::xml_node node = root.append_child("PFD");
    set(node, "A", fmt::format("PFD{}", ++partfields).c_str());
    set_name(node, "B", partfield.code);
    set(node, "C", shortened(partfield.name).c_str());
    set(node, "D", static_cast<unsigned>(std::lround(partfield.area_m2)));
    for (const TaskPolygon& polygon : partfield.polygons) append_polygon(node, polygon);
    for (const TaskLine& line : partfield.lines) append_line(node, line);
    for (const TaskPoint& point : partfield.points) {
      append_point(node, point.type, point.name, point.lon_lat_deg);
    }
    pugi::xml_node group;
    const std::string* name = nullptr;
    for (const GuidancePattern& pattern : partfield.guidance) {
      if (name == nullptr || *name != pattern.group) {
        group = node.append_child("GGP");
        set(group, "A", fmt::format("GGP{}", ++groups).c_str());
        set_name(group, "B", pattern.group);
        name = &pattern.group;
      }
      append_pattern(group, pattern, ++patterns);
    }
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace headland
