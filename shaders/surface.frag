// Cloth in the light of the lamps, from both sides: some of the light that falls on the other side comes through, and what
// faces the eye is a little lighter, so that folds show on the side away from the lamps too.
#version 330 core

uniform vec3 eye;            // m
uniform vec3 colour;
uniform float opacity;       // 0..1
uniform vec3 ramp[5];
uniform vec2 perCell;        // threads, checks or images to a cell of the sheet, across and down
uniform sampler2D image;

in vec3 point;
in vec3 facing;
in vec2 onSheet;
in float alongRamp;
out vec4 painted;

const float kLeast = 0.2;     // of the colour, where no light falls
const float kEye = 0.22;      // more, where it faces the eye
const float kLamps = 0.66;    // more, where it faces a lamp
const float kEdgeOn = 0.15;   // cosine between the normal and the line of sight
const float kThrough = 0.35;  // share of the light that comes through

#include "light.glsl"

// Drivers without a graphics card compute every branch for every pixel, so each pattern is a program of its own.
#if defined(PLAIN)
// Threads that cross over and under each other. They fade before they are too fine for the picture.
vec3 ownColour() {
  vec2 threads = onSheet * perCell, pixel = fwidth(threads);
  float clear = 1 - smoothstep(0.18, 0.42, max(pixel.x, pixel.y));
  vec2 cell = floor(threads), across = threads - cell - 0.5;
  bool warp = mod(cell.x + cell.y, 2.0) < 0.5;  // the thread on top runs down, or across
  vec2 on = warp ? across : across.yx;          // from its middle line, and along it
  float height = (1 - 1.5 * on.x * on.x) * (1 - on.y * on.y) / 0.802;
  return colour * mix(1.0, height * (warp ? 1.03 : 0.97), clear);
}
#elif defined(CHECKER)
// Dark where two stripes cross, as wide as the gaps between them. Each is averaged over the pixel.
vec3 ownColour() {
  vec2 at = onSheet * perCell, pixel = max(fwidth(at), vec2(1e-5));
  vec2 from = (at - 0.5 * pixel) / 2, to = (at + 0.5 * pixel) / 2;
  vec2 before = floor(from) + 2 * min(fract(from), 0.5), behind = floor(to) + 2 * min(fract(to), 0.5);
  vec2 dark = clamp((behind - before) / pixel, 0.0, 1.0);
  return mix(mix(vec3(0.93), colour, 0.04), colour, 0.5 * (dark.x + dark.y));
}
#elif defined(IMAGE)
vec3 ownColour() {
  vec4 picture = texture(image, onSheet * perCell);
  return mix(colour, picture.rgb, picture.a);
}
#elif defined(NUMBERS)
vec3 ownColour() {
  float along = clamp(alongRamp, 0.0, 1.0) * 4;
  int below = min(int(along), 3);
  return mix(ramp[below], ramp[below + 1], along - float(below));
}
#else
vec3 ownColour() { return colour; }
#endif

void main() {
  vec3 normal = normalize(facing), sight = normalize(eye - point);
  // Where a triangle is seen edge on, its own side and that of the rounded normal may differ: the normal's counts.
  float side = dot(normal, sight) + (gl_FrontFacing ? kEdgeOn : -kEdgeOn);
  if (side < 0.0) normal = -normal;
  float towardsEye = max(dot(normal, sight), 0.0);
  vec3 light = kLeast + kEye * towardsEye + kLamps * lampLight(point, normal, kThrough);
#if defined(NUMBERS)
  light = mix(vec3(1), light, 0.4);  // colours tell them
#endif
  painted = vec4(min(ownColour() * light, 1.0), opacity);
}
