// Darkens the floor where its mask says so, with a soft edge.
#version 330 core

uniform sampler2D mask;
uniform float strength;  // share of the light that the shadow takes
uniform vec2 edge;       // half of the width of the soft edge, as shares of the mask

in vec2 place;
out vec4 painted;

void main() {
  float cover = 0.0;
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      cover += texture(mask, place + vec2(column, row) * edge).r * float((2 - abs(row)) * (2 - abs(column)));
    }
  }
  if (cover <= 0.0) discard;
  painted = vec4(0, 0, 0, strength * cover / 16.0);
}
