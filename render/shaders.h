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
void main() {
  vec2 uv = (p_at.xy - classes_origin) / classes_size;
  bool on_raster = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0)));
  vec4 shares = texture(classes, uv) * (on_raster ? 1.0 : 0.0);
  vec3 ground = colour_at.rgb * max(0.0, 1.0 - dot(shares, vec4(1.0))) + once.rgb * shares.r +
                twice.rgb * shares.g + thrice.rgb * shares.b + missed.rgb * shares.a;
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

inline constexpr const char* kShadowFragmentShader = R"(#version 330 core
uniform vec4 shadow;
out vec4 colour;
void main() { colour = shadow; }
)";

}  // namespace headland
