// Cloth in the light of the lamps, from both sides: some of the light that falls on the other side comes through, and what
// faces the eye is a little lighter, so that folds show on the side away from the lamps too.
#version 330 core

uniform vec3 eye;            // m
uniform vec3 colour;
uniform bool coloured;       // by a number, with `ramp`
uniform vec3 ramp[5];
uniform int pattern;         // 0: none, 1: plain weave, 2: checks, 3: `image`
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
const float kThrough = 0.35;  // share of the light that comes through

#include "light.glsl"

// Threads that cross over and under each other. They fade before they are too fine for the picture.
vec3 plainWeave(vec3 own, vec2 threads, float pixel) {
  float clear = 1 - smoothstep(0.22, 0.55, pixel);
  if (clear <= 0.0) return own;
  vec2 cell = floor(threads), across = threads - cell - 0.5;
  bool warp = mod(cell.x + cell.y, 2.0) < 0.5;  // the thread on top runs down, or across
  vec2 on = warp ? across : across.yx;          // from its middle line, and along it
  float height = (1 - 1.9 * on.x * on.x) * (1 - 1.2 * on.y * on.y) / 0.757;
  return own * mix(1.0, height * (warp ? 1.03 : 0.97), clear);
}

// How much of a pixel the darker half of each stripe covers; stripes are as wide as the gaps between them.
vec2 stripes(vec2 at, vec2 pixel) {
  vec2 from = (at - 0.5 * pixel) / 2, to = (at + 0.5 * pixel) / 2;
  vec2 before = floor(from) + 2 * min(fract(from), 0.5), behind = floor(to) + 2 * min(fract(to), 0.5);
  return clamp((behind - before) / pixel, 0.0, 1.0);
}

vec3 ownColour() {
  vec2 at = onSheet * perCell, pixel = max(fwidth(at), vec2(1e-5));
  if (coloured) {
    float along = clamp(alongRamp, 0.0, 1.0) * 4;
    int below = min(int(along), 3);
    return mix(ramp[below], ramp[below + 1], along - float(below));
  }
  if (pattern == 1) return plainWeave(colour, at, max(pixel.x, pixel.y));
  if (pattern == 2) {
    vec2 dark = stripes(at, pixel);
    return mix(mix(vec3(0.93), colour, 0.04), colour, 0.5 * (dark.x + dark.y));
  }
  vec4 picture = pattern == 3 ? texture(image, at) : vec4(0);
  return mix(colour, picture.rgb, picture.a);
}

void main() {
  vec3 normal = normalize(gl_FrontFacing ? facing : -facing);
  float towardsEye = max(dot(normal, normalize(eye - point)), 0.0);
  vec3 light = kLeast + kEye * towardsEye + kLamps * lampLight(point, normal, kThrough);
  if (coloured) light = mix(vec3(1), light, 0.4);  // colours tell numbers
  painted = vec4(min(ownColour() * light, 1.0), 1);
}
