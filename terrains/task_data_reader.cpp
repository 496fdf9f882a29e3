#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <string_view>

#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "terrains/task_data.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

constexpr char kRoot[] = "ISO11783_TaskData";
constexpr char kExternalRoot[] = "XFC";
constexpr char kFileName[] = "TASKDATA.XML";
constexpr double kMetresPerMillimetre = 1e-3;
constexpr double kLargestUnsigned = 4294967295.0;

struct Document {
  std::string file;
  std::string text;
  pugi::xml_document xml;

  std::string line_text(std::ptrdiff_t offset) const {
    const auto length =
        std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text.size());
    return fmt::format(
        "line {}",
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
  }

  [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& attribute,
                           const std::string& value, const std::string& allowed) const {
    throw InputError(file,
                     fmt::format("{}, {}{}", line_text(node.offset_debug()), node.name(),
                                 attribute.empty() ? "" : " " + attribute),
                     value, allowed);
  }
};

fs::path task_file(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_directory(file, ignored)) return file;
  // Cards are written by systems that do not tell upper from lower case.
  for (const fs::directory_entry& entry : fs::directory_iterator(file, ignored)) {
    std::string name = entry.path().filename().string();
    std::ranges::transform(name, name.begin(), [](unsigned char sign) {
      return static_cast<char>(std::toupper(sign));
    });
    if (name == kFileName) return entry.path();
  }
  return file / kFileName;
}

void load(const fs::path& file, const char* root, Document& document) {
  document.file = file.string();
  document.text = read_text(file);
  const pugi::xml_parse_result parsed =
      document.xml.load_buffer(document.text.data(), document.text.size());
  if (!parsed) {
    throw InputError(document.file, document.line_text(parsed.offset), "",
                     std::string("malformed XML: ") + parsed.description());
  }
  if (document.xml.document_element().name() != std::string_view(root)) {
    throw InputError(document.file, document.line_text(0), document.xml.document_element().name(),
                     fmt::format("the root element of such a file is {}", root));
  }
}

double number(const Document& in, const pugi::xml_node& node, const char* attribute, double least,
              double most, const std::string& what) {
  const std::string_view text = node.attribute(attribute).value();
  double value = std::numeric_limits<double>::quiet_NaN();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= least && value <= most) {
    return value;
  }
  in.refuse(node, attribute, std::string(text),
            fmt::format("{}: a number from {} to {}", what, least, most));
}

double number_or(const Document& in, const pugi::xml_node& node, const char* attribute,
                 double otherwise, const std::string& what) {
  if (node.attribute(attribute).value()[0] == '\0') return otherwise;
  return number(in, node, attribute, 0.0, kLargestUnsigned, what);
}

int type_of(const Document& in, const pugi::xml_node& node, const char* attribute, int most,
            const std::string& what) {
  const double value = number(in, node, attribute, 1.0, most, what);
  if (value == std::floor(value)) return static_cast<int>(value);
  in.refuse(node, attribute, node.attribute(attribute).value(), what + ": a whole number");
}

TaskPoint point_of(const Document& in, const pugi::xml_node& node) {
  constexpr int kMostTypes = 11;
  constexpr double kNorth_deg = 90.0;
  constexpr double kEast_deg = 180.0;
  if (node.attribute("J")) {
    in.refuse(node, "J", node.attribute("J").value(),
              "points in a binary file are not read; have them written into the XML");
  }
  TaskPoint point;
  point.type = static_cast<TaskPointType>(type_of(in, node, "A", kMostTypes, "type of the point"));
  point.name = node.attribute("B").value();
  point.lon_lat_deg.y() = number(in, node, "C", -kNorth_deg, kNorth_deg, "latitude in degrees");
  point.lon_lat_deg.x() = number(in, node, "D", -kEast_deg, kEast_deg, "longitude in degrees");
  return point;
}

bool is_ring(TaskLineType type) {
  return type == TaskLineType::kExterior || type == TaskLineType::kInterior;
}

TaskLine line_of(const Document& in, const pugi::xml_node& node) {
  constexpr int kMostTypes = 9;
  TaskLine line;
  line.type = static_cast<TaskLineType>(type_of(in, node, "A", kMostTypes, "type of the line"));
  line.name = node.attribute("B").value();
  line.width_m = kMetresPerMillimetre * number_or(in, node, "C", 0.0, "width in mm");
  for (const pugi::xml_node& point : node.children("PNT")) {
    line.lon_lat_deg.push_back(point_of(in, point).lon_lat_deg);
  }
  if (line.lon_lat_deg.empty()) in.refuse(node, "", "", "a line without points (PNT)");
  // Rings are closed by their first point since version 4, and without it before.
  while (is_ring(line.type) && line.lon_lat_deg.size() > 1 &&
         line.lon_lat_deg.front() == line.lon_lat_deg.back()) {
    line.lon_lat_deg.pop_back();
  }
  return line;
}

TaskPolygon polygon_of(const Document& in, const pugi::xml_node& node) {
  constexpr int kMostTypes = 12;
  TaskPolygon polygon;
  polygon.type =
      static_cast<TaskPolygonType>(type_of(in, node, "A", kMostTypes, "type of the polygon"));
  polygon.name = node.attribute("B").value();
  for (const pugi::xml_node& line : node.children("LSG")) {
    TaskLine ring = line_of(in, line);
    if (!is_ring(ring.type)) {
      in.refuse(line, "A", line.attribute("A").value(),
                "a polygon consists of lines of type 1 (exterior) and 2 (interior)");
    }
    polygon.rings.push_back(std::move(ring));
  }
  return polygon;
}

GuidancePattern pattern_of(const Document& in, const pugi::xml_node& node,
                           const std::string& group) {
  constexpr int kMostKinds = 5;
  GuidancePattern pattern;
  pattern.group = group;
  pattern.name = node.attribute("B").value();
  pattern.kind = static_cast<GuidanceKind>(type_of(in, node, "C", kMostKinds, "type of guidance"));
  const double propagation =
      number_or(in, node, "E", static_cast<double>(Propagation::kBoth), "direction of propagation");
  pattern.repeats = propagation != static_cast<double>(Propagation::kNone);
  const pugi::xml_node line = node.child("LSG");
  if (!line) in.refuse(node, "", "", "a guidance pattern without its line (LSG)");
  pattern.line = line_of(in, line);
  return pattern;
}

Partfield partfield_of(const Document& in, const pugi::xml_node& node) {
  Partfield partfield;
  partfield.id = node.attribute("A").value();
  partfield.code = node.attribute("B").value();
  partfield.name = node.attribute("C").value();
  partfield.area_m2 = number_or(in, node, "D", 0.0, "area in m2");
  for (const pugi::xml_node& polygon : node.children("PLN")) {
    partfield.polygons.push_back(polygon_of(in, polygon));
  }
  for (const pugi::xml_node& point : node.children("PNT")) {
    partfield.points.push_back(point_of(in, point));
  }
  for (const pugi::xml_node& child : node.children("LSG")) {
    TaskLine line = line_of(in, child);
    if (line.type == TaskLineType::kGuidance) {
      const GuidanceKind kind =
          line.lon_lat_deg.size() > 2 ? GuidanceKind::kCurve : GuidanceKind::kAb;
      partfield.guidance.push_back({"", line.name, kind, true, std::move(line)});
    } else {
      partfield.lines.push_back(std::move(line));
    }
  }
  for (const pugi::xml_node& group : node.children("GGP")) {
    for (const pugi::xml_node& pattern : group.children("GPN")) {
      partfield.guidance.push_back(pattern_of(in, pattern, group.attribute("B").value()));
    }
  }
  return partfield;
}

void append_partfields(const Document& in, TaskData& data) {
  for (const pugi::xml_node& node : in.xml.document_element().children("PFD")) {
    data.partfields.push_back(partfield_of(in, node));
  }
}

// The file beside this one that an XFR refers to by its name without extension, as PFD00001.
fs::path external_file(const Document& in, const pugi::xml_node& node) {
  const std::string name = node.attribute("A").value();
  const auto is = [&name](std::size_t from, std::size_t to, auto kind) {
    return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(from),
                       name.begin() + static_cast<std::ptrdiff_t>(to), kind);
  };
  constexpr std::size_t kLetters = 3;
  constexpr std::size_t kLength = 8;
  if (name.size() != kLength || !is(0, kLetters, [](char c) { return c >= 'A' && c <= 'Z'; }) ||
      !is(kLetters, kLength, [](char c) { return c >= '0' && c <= '9'; })) {
    in.refuse(node, "A", name, "three letters and five digits name a file beside this one");
  }
  const fs::path folder = fs::path(in.file).parent_path();
  const fs::path lower = folder / (name + ".xml");
  return fs::exists(lower) ? lower : folder / (name + ".XML");
}

}  // namespace

bool is_task_data(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return fs::exists(task_file(file), ignored);
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char sign) { return static_cast<char>(std::tolower(sign)); });
  if (extension != ".xml") return false;
  return read_text(file).find(std::string("<") + kRoot) != std::string::npos;
}

TaskData read_task_data(const fs::path& file) {
  TaskData data;
  Document main;
  load(task_file(file), kRoot, main);
  append_partfields(main, data);
  for (const pugi::xml_node& node : main.xml.document_element().children("XFR")) {
    if (!std::string_view(node.attribute("A").value()).starts_with("PFD")) continue;
    Document external;
    load(external_file(main, node), kExternalRoot, external);
    append_partfields(external, data);
  }
  return data;
}

}  // namespace headland
