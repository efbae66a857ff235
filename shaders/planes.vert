// A square of a plane, which holds the disc that is shown.
#version 330 core

uniform mat4 view;
uniform mat4 projection;
uniform vec3 middle;  // of the disc, m
uniform vec3 across;  // unit vectors in the plane
uniform vec3 along;
uniform float radius;  // of the disc, m

out vec2 point;  // from the middle, m

void main() {
  point = radius * vec2((gl_VertexID & 1) == 0 ? -1 : 1, (gl_VertexID & 2) == 0 ? -1 : 1);
  gl_Position = projection * view * vec4(middle + point.x * across + point.y * along, 1);
}
