// Sky, ground and a grid on it that fades out with distance, for bearings.
#version 330 core

uniform vec3 sky;
uniform vec3 ground;
uniform vec3 grid;
uniform vec3 eye;       // m
uniform float height;   // of the ground, m
uniform float cell;     // m between grid lines
uniform vec2 middle;    // x and z of the point around which the grid is drawn, m
uniform float extent;   // how far it is drawn, m

in vec3 sight;
out vec4 painted;

// How much of a pixel lines at every multiple of `step` cover; lines too dense to tell apart fade away.
float gridCover(vec2 point, vec2 pixel, float step) {
  vec2 away = abs(fract(point / step + 0.5) - 0.5) * step;
  vec2 cover = clamp(1.1 - away / pixel, 0.0, 1.0) * (1 - smoothstep(0.12, 0.4, pixel / step));
  return max(cover.x, cover.y);
}

void main() {
  vec3 direction = normalize(sight);
  vec3 colour = mix(ground, sky, smoothstep(-0.25, 0.12, direction.y));
  float distanceDown = height - eye.y;
  bool meets = direction.y * distanceDown > 0.0;
  float t = meets ? distanceDown / direction.y : 1e4 * cell;
  vec2 point = eye.xz + min(t, 1e4 * cell) * direction.xz;
  vec2 pixel = max(fwidth(point), vec2(1e-9 * cell));
  float near = 1 - smoothstep(0.15, 1.0, distance(point, middle) / extent);
  float cover = max(0.45 * gridCover(point, pixel, cell), gridCover(point, pixel, 5 * cell));
  painted = vec4(mix(colour, grid, meets ? near * cover : 0.0), 1);
}
