// A plane as a disc with a grid that moves with it, which fades out towards its edge.
#version 330 core

uniform vec3 colour;
uniform vec3 grid;
uniform vec2 origin;    // from a crossing of the grid to the disc's middle, m
uniform float cell;     // m between grid lines
uniform float radius;   // of the disc, m
uniform float fill;     // 1: the plane is drawn, 0: its grid alone
uniform float opacity;  // 0..1

in vec2 point;
out vec4 painted;

// As in surroundings.frag.
float gridCover(vec2 point, vec2 pixel, float step) {
  vec2 away = abs(fract(point / step + 0.5) - 0.5) * step;
  vec2 cover = clamp(1.1 - away / pixel, 0.0, 1.0) * (1 - smoothstep(0.12, 0.4, pixel / step));
  return max(cover.x, cover.y);
}

void main() {
  vec2 place = point + origin;
  vec2 pixel = max(fwidth(place), vec2(1e-9 * cell));
  float cover = max(0.45 * gridCover(place, pixel, cell), gridCover(place, pixel, 5 * cell));
  float near = 1 - smoothstep(0.35, 1.0, length(point) / radius);
  float alpha = opacity * near * mix(cover, 1.0, fill);
  if (alpha < 0.02) discard;
  painted = vec4(mix(colour, grid, cover), alpha);
}
