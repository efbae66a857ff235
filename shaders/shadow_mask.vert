// Takes the cloth, or a body, to its shadow on the floor.
#version 330 core

layout(location = 0) in vec3 position;  // m, in the thing's own axes
uniform mat4 model;                     // from there to the world's
uniform mat4 shadow;                    // from the world to the mask
uniform vec4 floorPlane;                // its normal, and less the height of it along the normal, m

out float height;  // above the floor, m

void main() {
  vec4 place = model * vec4(position, 1);
  height = dot(floorPlane, place);
  gl_Position = shadow * place;
}
