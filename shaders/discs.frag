// A disc with a soft edge, and an outline in the background's colour that sets it off from the lines.
#version 330 core

uniform vec3 colour;
uniform vec3 background;
uniform float fade;     // as in lines.frag
uniform float outline;  // pixels

in float radius;
in float opacity;
in float farness;
out vec4 painted;

void main() {
  float away = length(gl_PointCoord - 0.5) * 2 * (radius + 1.0);
  float cover = clamp(radius + 0.5 - away, 0.0, 1.0);
  if (cover <= 0.0) discard;
  float inner = clamp(radius - outline + 0.5 - away, 0.0, 1.0);
  painted = vec4(mix(background, mix(colour, background, fade * farness), inner), cover * opacity);
}
