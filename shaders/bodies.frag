// Lit from above, from the left and from the front of the scene. The light wraps around (half of Lambert's cosine, and a
// half), so that no side is without shape.
#version 330 core

uniform vec3 colour;
uniform float opacity;  // 0..1

in vec3 facing;
out vec4 painted;

const vec3 kLight = vec3(-0.42, 0.80, 0.43);  // towards it, of unit length
const float kLeast = 0.45;                    // of the colour, on the side away from the light

void main() {
  float light = 0.5 + 0.5 * dot(normalize(facing), kLight);
  painted = vec4(colour * mix(kLeast, 1.0, light * light), opacity);
}
