// A solid thing with a normal at each of its vertices.
#version 330 core

layout(location = 0) in vec3 position;  // in the thing's own axes
layout(location = 1) in vec3 normal;    // there, of unit length
uniform mat4 model;                     // from there to the world's; turns and scales every way alike
uniform mat4 view;
uniform mat4 projection;

out vec3 facing;  // as the eye sees it

void main() {
  vec4 seen = view * (model * vec4(position, 1));
  facing = mat3(view) * (mat3(model) * normal);
  gl_Position = projection * seen;
}
