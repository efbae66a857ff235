// The soft edge of a line, and its colour faded with distance. Drawn twice: first the solid middles, which hide what is
// behind them, then the soft edges, which hide nothing. Drawn at once, the edge of a near line would cut into a far one.
#version 330 core

uniform vec3 colour;
uniform vec3 background;
uniform float fade;          // how far the farthest part of the cloth goes towards the background, 0..1
uniform int colouring;       // 0: `colour`, else from `ramp`
uniform vec3 ramp[5];
uniform float opacityOfAll;  // 0..1
uniform int part;            // 0: middles, 1: edges, 2: both at once

noperspective in float across;
noperspective in float halfWidth;
noperspective in float opacity;
noperspective in float tone;
in float alongRamp;
in float farness;
out vec4 painted;

void main() {
  float cover = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0);
  bool solid = cover >= 0.5 && tone <= 0.0;
  if (cover <= 0.0 || (part == 0 && !solid) || (part == 1 && solid)) discard;
  vec3 own = colour;
  if (colouring != 0) {
    float at = clamp(alongRamp, 0.0, 1.0) * 4;
    int below = min(int(at), 3);
    own = mix(ramp[below], ramp[below + 1], at - float(below));
  }
  painted = vec4(mix(own, background, fade * farness), cover * opacity * opacityOfAll);
}
