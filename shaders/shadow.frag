// Darkens the floor where its mask says so, with a soft edge.
#version 330 core

uniform sampler2D mask;
uniform float strength;  // share of the light that the shadow takes

in vec2 place;
out vec4 painted;

void main() {
  // A mean over about three pixels of the mask: four samples between pixels, each the mean of four.
  vec2 pixel = 1.0 / vec2(textureSize(mask, 0));
  float cover = 0.0;
  for (int k = 0; k < 4; ++k) cover += texture(mask, place + 0.75 * pixel * vec2(k % 2 * 2 - 1, k / 2 * 2 - 1)).r;
  if (cover <= 0.0) discard;
  painted = vec4(0, 0, 0, strength * cover / 4);
}
