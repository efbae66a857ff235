// A triangle that covers the window, with the line of sight through each of its points.
#version 330 core

uniform vec3 forward;   // along the line of sight
uniform vec3 rightward; // to the window's right edge, seen from the distance of `forward`
uniform vec3 upward;    // to its upper edge

out vec3 sight;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
  sight = forward + corner.x * rightward + corner.y * upward;
  gl_Position = vec4(corner, 0, 1);
}
