#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <array>
#include <memory>

#include "evaluate/path_export.h"
#include "terrains/gdal_scope.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

// A file in GDAL's memory, gone with this.
struct MemoryFile {
  explicit MemoryFile(std::string file) : name(std::move(file)) {}
  ~MemoryFile() { VSIUnlink(name.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string text() const {
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(name.c_str(), &size, FALSE);
    if (bytes == nullptr) return {};
    return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
  }

  std::string name;
};

constexpr std::array kTexts = {"kind", "gear", "implement", "reference"};

// Work apart from the ways between it, on any map.
const char* style_of(const PathSegment& segment) {
  if (segment.implement_down) return "PEN(c:#1F78B4,w:3px)";
  return segment.gear == Gear::kReverse ? "PEN(c:#E31A1C,w:2px)" : "PEN(c:#FF7F00,w:2px)";
}

// `lon_lat_deg` of all points of the path, in their order.
void write_segments(const Path& path, const std::vector<Eigen::Vector2d>& lon_lat_deg,
                    OGRLayer& layer, bool named_field) {
  if (named_field) {
    OGRFieldDefn name("Name", OFTString);
    layer.CreateField(&name);
  }
  for (const char* key : kTexts) {
    OGRFieldDefn text(key, OFTString);
    layer.CreateField(&text);
  }
  OGRFieldDefn manoeuvre("manoeuvre", OFTInteger);
  layer.CreateField(&manoeuvre);
  OGRFieldDefn length("length_m", OFTReal);
  layer.CreateField(&length);
  std::size_t next = 0;
  int number = 0;
  for (const PathSegment& segment : path.segments) {
    OGRFeature feature(layer.GetLayerDefn());
    const std::string kind(path_kind_name(segment.kind));
    feature.SetField(named_field ? "Name" : "name", fmt::format("{} {}", ++number, kind).c_str());
    feature.SetField("kind", kind.c_str());
    feature.SetField("gear", std::string(gear_name(segment.gear)).c_str());
    feature.SetField("implement", segment.implement_down ? "down" : "up");
    feature.SetField("reference", "vehicle");
    feature.SetField("manoeuvre", segment.manoeuvre);
    feature.SetField("length_m", length_m(segment));
    OGRLineString line;
    for (std::size_t i = 0; i < segment.points.size(); ++i, ++next) {
      line.addPoint(lon_lat_deg[next].x(), lon_lat_deg[next].y());
    }
    feature.SetGeometry(&line);
    feature.SetStyleString(style_of(segment));
    if (layer.CreateFeature(&feature) != OGRERR_NONE) {
      throw InputError("path", "", kind, "GDAL could not write a segment");
    }
  }
}

void write_outline(const Field& field, OGRLayer& layer) {
  OGRFieldDefn name("Name", OFTString);
  layer.CreateField(&name);
  OGRPolygon polygon;
  const auto add = [&](const Ring& ring_W) {
    OGRLinearRing ring;
    for (const Eigen::Vector2d& point : wgs84_from_local(field.frame, ring_W)) {
      ring.addPoint(point.x(), point.y());
    }
    ring.closeRings();
    polygon.addRing(&ring);
  };
  add(field.boundary);
  for (const Ring& hole : field.holes) add(hole);
  OGRFeature feature(layer.GetLayerDefn());
  feature.SetField("Name", field.name.c_str());
  feature.SetGeometry(&polygon);
  feature.SetStyleString("PEN(c:#33A02C,w:2px);BRUSH(fc:#33A02C20)");
  if (layer.CreateFeature(&feature) != OGRERR_NONE) {
    throw InputError(field.name, "", "", "GDAL could not write the field's outline");
  }
}

}  // namespace

std::string path_layers(const PathExport& made, ExportFormat format) {
  const GdalScope gdal;
  const bool gpx = format == ExportFormat::kGpx;
  const MemoryFile file(fmt::format("/vsimem/headland_{}.{}", static_cast<const void*>(&gdal),
                                    export_format_name(format)));
  // Where more than one driver writes KML, the one that writes typed properties.
  GDALDriver* driver = nullptr;
  for (const char* name : gpx ? std::array{"GPX", "GPX"} : std::array{"LIBKML", "KML"}) {
    if (driver == nullptr) driver = GetGDALDriverManager()->GetDriverByName(name);
  }
  if (driver == nullptr) {
    throw InputError(std::string(export_format_name(format)), "", "",
                     "this build of GDAL does not write the format");
  }
  constexpr std::array<const char*, 4> kGpxOptions = {
      "GPX_USE_EXTENSIONS=YES", "GPX_EXTENSIONS_NS=headland",
      "GPX_EXTENSIONS_NS_URL=urn:headland:path", nullptr};
  constexpr std::array<const char*, 1> kNoOptions = {nullptr};
  std::unique_ptr<GDALDataset, CloseDataset> dataset(
      driver->Create(file.name.c_str(), 0, 0, 0, GDT_Unknown,
                     const_cast<char**>(gpx ? kGpxOptions.data() : kNoOptions.data())));
  OGRSpatialReference wgs84 = spatial_reference("EPSG:4326", "");
  OGRLayer* layer = dataset == nullptr
                        ? nullptr
                        : dataset->CreateLayer(gpx ? "tracks" : "path", &wgs84,
                                               gpx ? wkbMultiLineString : wkbLineString, nullptr);
  if (layer == nullptr) throw InputError("path", "", "", "GDAL: " + gdal.complaint());
  std::vector<Eigen::Vector2d> points;
  for (const PathSegment& segment : made.path.segments) {
    for (const PathPoint& point : segment.points) points.push_back(point.p_W);
  }
  write_segments(made.path, wgs84_from_local(made.field.frame, points), *layer, !gpx);
  if (!gpx) {
    OGRLayer* outline = dataset->CreateLayer("field", &wgs84, wkbPolygon, nullptr);
    if (outline == nullptr) throw InputError("field", "", "", "GDAL: " + gdal.complaint());
    write_outline(made.field, *outline);
  }
  dataset.reset();  // writes it
  return file.text();
}

}  // namespace headland
