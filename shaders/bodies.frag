// A body in the light of the lamps.
#version 330 core

uniform vec3 colour;
uniform float opacity;  // 0..1

in vec3 point;
in vec3 facing;
out vec4 painted;

const float kLeast = 0.45;  // of the colour, on the side away from the light

#include "light.glsl"

void main() {
  painted = vec4(min(colour * mix(vec3(kLeast), vec3(1.0), lampLight(point, normalize(facing), 0.0)), 1.0), opacity);
}
