// The part of the floor that a shadow covers.
#version 330 core

uniform mat4 view;
uniform mat4 projection;
uniform vec3 middle;  // m
uniform vec3 across;  // from there to two edges, m
uniform vec3 along;

out vec2 place;  // in the mask

void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1 : 1, (gl_VertexID & 2) == 0 ? -1 : 1);
  place = 0.5 + 0.5 * corner;
  gl_Position = projection * view * vec4(middle + corner.x * across + corner.y * along, 1);
}
