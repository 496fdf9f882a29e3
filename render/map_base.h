// What both maps from above share: the ground, the field's lines, start and end.
#pragma once

#include <string>

#include "render/coverage_classes.h"
#include "render/page.h"
#include "render/pictures.h"
#include "render/terrain_surface.h"
#include "render/track_arrows.h"

namespace headland {

struct MapView {
  MapCamera camera;
  Relief relief;           // its exaggeration is of the shading alone
  HeightRange heights;     // inside the field's extent
  double contour_m = 0.0;  // 0: too level for contours
};
MapView map_view(const PictureScene& scene, const Page& page);

// Shaded ground with contours and coverage, on the graphics side. Its nodes lie about `spacing_px`
// apart where the terrain has so many: finer ones are not seen and cost time.
inline constexpr double kFineGround_px = 2.0;
inline constexpr double kMovingGround_px = 6.0;  // for one picture among many
struct MapGround {
  MapGround(const PictureScene& scene, const MapView& view, const CoverageClasses& classes,
            const SurfaceLook& look, Rgba ground, double spacing_px = kFineGround_px);
  GlTriangles surface;
  SurfaceCoverage coverage;
  SurfaceLook look;
  Eigen::Matrix4f clip;
};

// Inside the map's window.
void paint_map_ground(const Canvas& canvas, const MapView& view, const MapGround& ground);

// A map and what stands on the page around it: the ground, lines within the map's window, the
// margin.
struct MapSheets {
  Sheet map;
  Sheet margin;
};
Image draw_map_page(const Page& page, const Typeface& typeface, const MapView& view,
                    const MapGround& ground, const MapSheets& sheets);

// Boundary, hatched holes, obstacles.
void draw_field_lines(Sheet& sheet, const PictureScene& scene, const Page& page,
                      const MapView& view);

// Where the run, or failing that the path, starts (triangle) and ends (square).
void draw_start_and_end(Sheet& sheet, const PictureScene& scene, const Page& page,
                        const MapView& view);

// The machine at a moment of the run.
void mark_vehicle(Sheet& sheet, const Page& page, const Eigen::Vector2d& p_px, double yaw_rad);

// Legend entries of the two functions above, of what the field has and what is known of it.
void legend_field(Legend& legend, const PictureScene& scene);
void legend_relief(Legend& legend, const PictureScene& scene, const MapView& view);
void legend_start_and_end(Legend& legend, const PictureScene& scene);

// Frame of the map with the coordinates of W along it, scale bar, north arrow.
void draw_map_frame(Sheet& sheet, Typeface& typeface, const Page& page, const MapView& view);

// Of the driven track, or failing that the path; how its direction is drawn.
std::vector<Eigen::Vector3d> track_line(const MapView& view, const PictureScene& scene);
ArrowLook track_arrows(const Page& page, Rgba colour);

// Pixels of a line in W.
std::vector<Eigen::Vector3d> map_line(const MapView& view,
                                      const std::vector<Eigen::Vector2d>& line_W);

}  // namespace headland
