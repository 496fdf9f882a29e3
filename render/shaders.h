// The GLSL programs of the pictures.
#pragma once

namespace headland {

// Flat drawing in pixels (render/sheet.h).
inline constexpr const char* kSheetVertexShader = R"(#version 330 core
layout(location = 0) in vec3 p_px;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 colour;
uniform vec2 frame_px;
out vec2 texel_at;
out vec4 colour_at;
void main() {
  gl_Position = vec4(2.0 * p_px.x / frame_px.x - 1.0, 1.0 - 2.0 * p_px.y / frame_px.y, p_px.z, 1.0);
  texel_at = texel;
  colour_at = colour;
}
)";

inline constexpr const char* kSheetFragmentShader = R"(#version 330 core
in vec2 texel_at;
in vec4 colour_at;
uniform sampler2D ink;
out vec4 colour;
void main() {
  float strength = texelFetch(ink, ivec2(floor(texel_at)), 0).r;
  colour = vec4(colour_at.rgb, colour_at.a * strength);
}
)";

// Terrain and solid bodies share the vertex shader (render/mesh.h). Positions are in frame D:
// W with heights taken from a base and stretched.
inline constexpr const char* kSolidVertexShader = R"(#version 330 core
layout(location = 0) in vec3 p_D;
layout(location = 1) in vec3 normal_D;
layout(location = 2) in vec4 colour;
uniform mat4 clip_from_D;
out vec3 p_at;
out vec3 normal_at;
out vec4 colour_at;
void main() {
  gl_Position = clip_from_D * vec4(p_D, 1.0);
  p_at = p_D;
  normal_at = normal_D;
  colour_at = colour;
}
)";

// Level ground has exactly the colour it is given, so that legends hold; slopes towards the sun
// are lighter, others darker. `classes` holds, per texel, the shares worked once, twice, more often
// and missed; what is left is ground.
inline constexpr const char* kTerrainFragmentShader = R"(#version 330 core
in vec3 p_at;
in vec3 normal_at;
in vec4 colour_at;
uniform vec3 to_sun;
uniform float shading;
uniform float grain;
uniform sampler2D classes;
uniform vec2 classes_origin;
uniform vec2 classes_size;
uniform vec4 once, twice, thrice, missed;
uniform float contour_step;      // in D; 0: none
uniform vec4 contour_colour;     // its alpha is the lines' strength
uniform vec2 fade_centre;
uniform vec2 fade_from_to;       // distances; 0, 0: no fading
uniform vec4 fade_colour;
out vec4 colour;

// Even noise of 0..1 with features a metre apart.
float hash(vec2 cell) {
  vec3 p = fract(vec3(cell.xyx) * 0.1031);
  p += dot(p, p.yzx + 33.33);
  return fract((p.x + p.y) * p.z);
}
float noise(vec2 p) {
  vec2 cell = floor(p);
  vec2 f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(cell), hash(cell + vec2(1.0, 0.0)), f.x),
             mix(hash(cell + vec2(0.0, 1.0)), hash(cell + vec2(1.0, 1.0)), f.x), f.y);
}

void main() {
  vec2 uv = (p_at.xy - classes_origin) / classes_size;
  bool on_raster = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0)));
  vec4 shares = texture(classes, uv) * (on_raster ? 1.0 : 0.0);
  vec3 ground = colour_at.rgb * max(0.0, 1.0 - dot(shares, vec4(1.0))) + once.rgb * shares.r +
                twice.rgb * shares.g + thrice.rgb * shares.b + missed.rgb * shares.a;
  if (grain > 0.0) {
    // Clods, tufts and patches, each as long as it is larger than a pixel.
    float pixel_m = length(fwidth(p_at.xy));
    float clods = (noise(p_at.xy * 9.0) - 0.5) * (1.0 - smoothstep(0.04, 0.12, pixel_m));
    float tufts = (noise(p_at.xy * 2.3 + 17.0) - 0.5) * (1.0 - smoothstep(0.2, 0.5, pixel_m));
    float patches = (noise(p_at.xy * 0.21 + 5.0) - 0.5) * (1.0 - smoothstep(2.0, 6.0, pixel_m));
    ground *= 1.0 + grain * (0.28 * clods + 0.16 * tufts + 0.14 * patches);
  }
  float light = dot(normalize(normal_at), to_sun) / to_sun.z;
  float change = shading * (light - 1.0);
  // Lit slopes go towards white, whatever their colour; shaded ones never to black.
  ground = change > 0.0 ? mix(ground, vec3(1.0), 0.45 * (1.0 - exp(-1.3 * change)))
                        : ground * (1.0 - 0.6 * (1.0 - exp(1.5 * change)));
  if (contour_step > 0.0) {
    float level = p_at.z / contour_step;
    float per_pixel = fwidth(level);
    if (per_pixel > 1e-5 && per_pixel < 0.5) {
      float distance_px = abs(fract(level - 0.5) - 0.5) / per_pixel;
      ground = mix(ground, contour_colour.rgb,
                   contour_colour.a * (1.0 - smoothstep(0.35, 1.15, distance_px)));
    }
  }
  if (fade_from_to.y > 0.0) {
    float away = distance(p_at.xy, fade_centre);
    ground = mix(ground, fade_colour.rgb, smoothstep(fade_from_to.x, fade_from_to.y, away));
  }
  colour = vec4(min(ground, vec3(1.0)), 1.0);
}
)";

// Sun from one side, sky from above, some light back from the ground.
inline constexpr const char* kSolidFragmentShader = R"(#version 330 core
in vec3 p_at;
in vec3 normal_at;
in vec4 colour_at;
uniform vec3 to_sun;
uniform vec3 eye_D;
out vec4 colour;
void main() {
  // Meshes from elsewhere are not always wound the same way round.
  vec3 normal = normalize(normal_at) * (dot(normal_at, eye_D - p_at) < 0.0 ? -1.0 : 1.0);
  float sun = max(0.0, dot(normal, to_sun));
  float sky = 0.5 + 0.5 * normal.z;
  colour = vec4(min(colour_at.rgb * (0.34 + 0.30 * sky + 0.52 * sun), vec3(1.0)), colour_at.a);
}
)";

// Strips of worked ground, furrow beside furrow: bright on the one side, dark on the other, gone
// where they are narrower than pixels. What was worked after `now` is not there.
inline constexpr const char* kFurrowVertexShader = R"(#version 330 core
layout(location = 0) in vec3 p_D;
layout(location = 1) in vec2 across_time;
uniform mat4 clip_from_D;
out vec3 p_at;
out vec2 across_time_at;
void main() {
  gl_Position = clip_from_D * vec4(p_D, 1.0);
  p_at = p_D;
  across_time_at = across_time;
}
)";

inline constexpr const char* kFurrowFragmentShader = R"(#version 330 core
in vec3 p_at;
in vec2 across_time_at;
uniform float now;
uniform float spacing;
uniform float width;             // of a strip; its sides are drawn as lines
uniform vec2 fade_centre;
uniform vec2 fade_from_to;
out vec4 colour;
void main() {
  if (across_time_at.y > now) discard;
  float pixel = fwidth(across_time_at.x);
  float near = 1.0;
  if (fade_from_to.y > 0.0) {
    near = 1.0 - smoothstep(fade_from_to.x, fade_from_to.y, distance(p_at.xy, fade_centre));
  }
  float side = sin(6.2831853 * across_time_at.x / spacing);
  float furrow = (1.0 - smoothstep(0.2, 0.55, pixel / spacing)) * abs(side) *
                 (side < 0.0 ? 0.42 : 0.26);
  // As much of the pixel as a line along the strip's side fills.
  float line_m = 0.02 * width;
  float from_side = min(across_time_at.x, width - across_time_at.x);
  float edge = 0.5 * clamp((line_m - from_side) / pixel + 0.5, 0.0, 1.0) *
               min(1.0, 2.0 * line_m / pixel);
  vec3 dark = vec3(0.20, 0.13, 0.08);
  colour = vec4(side < 0.0 || edge > furrow ? dark : vec3(0.80, 0.68, 0.52),
                near * max(furrow, edge));
}
)";

inline constexpr const char* kShadowFragmentShader = R"(#version 330 core
uniform vec4 shadow;
out vec4 colour;
void main() { colour = shadow; }
)";

}  // namespace headland
