// A particle as a point sprite of a size in pixels.
#version 330 core

layout(location = 0) in vec3 position;  // m
uniform mat4 view;
uniform mat4 projection;
uniform float focal;      // pixels per metre at a distance of one metre
uniform float diameter;   // pixels, at the distance `middle`
uniform float least;      // pixels; not drawn smaller, but fainter
uniform float spacing;    // m between neighbouring discs; 0: not made smaller where they are dense
uniform float middle;     // distance to the middle of the cloth, m
uniform vec2 depths;      // of the nearest and the farthest part of the cloth, m

out float radius;         // pixels
out float opacity;
out float farness;

const float kFringe = 1.0;  // pixels around the disc for its soft edge

void main() {
  vec4 seen = view * vec4(position, 1);
  float depth = max(-seen.z, 1e-6);
  float wanted = diameter * clamp(middle / depth, 0.7, 1.6);
  if (spacing > 0.0) wanted = min(wanted, 0.45 * spacing * focal / depth);
  float drawn = max(wanted, least);
  opacity = min(wanted / drawn, 1.0);
  radius = drawn / 2;
  farness = clamp((depth - depths.x) / (depths.y - depths.x), 0.0, 1.0);
  gl_PointSize = drawn + 2 * kFringe;
  // A little nearer than the lines that end in it, so that they do not cut it up.
  seen.xyz *= 0.995;
  gl_Position = projection * seen;
}
