// Lit from above the eye's left shoulder (Lambert 1760), and never quite dark.
#version 330 core

uniform vec3 colour;

in vec3 facing;
out vec4 painted;

const vec3 kLight = vec3(-0.37, 0.74, 0.56);  // towards it, of unit length
const float kLeast = 0.4;                     // of the colour, where no light falls

void main() {
  float light = max(dot(normalize(facing), kLight), 0.0);
  painted = vec4(colour * mix(kLeast, 1.0, light), 1);
}
