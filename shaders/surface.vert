// The surface of the cloth: a vertex for each particle, and more beside cuts.
#version 330 core

layout(location = 0) in vec3 position;  // m
layout(location = 1) in vec3 normal;    // of any length
layout(location = 2) in vec2 place;     // beside cuts: column and row
layout(location = 3) in uint particle;  // beside cuts: whose colour it has
uniform mat4 view;
uniform mat4 projection;
uniform vec2 aside;                     // by how much it is drawn beside its place; the picture is two wide and high
uniform int columns;                    // of the sheet
uniform bool besideCut;
uniform samplerBuffer values;           // a number of each particle
uniform vec2 range;                     // the numbers at both ends of the colours

out vec3 point;        // m
out vec3 facing;
out vec2 onSheet;      // column and row
out float alongRamp;   // 0 at the first of the colours, 1 at the last

void main() {
  int number = besideCut ? int(particle) : gl_VertexID;
  onSheet = besideCut ? place : vec2(number % columns, number / columns);
  alongRamp = 0.0;
#if defined(NUMBERS)
  alongRamp = (texelFetch(values, number).r - range.x) / max(range.y - range.x, 1e-30);
#endif
  point = position;
  facing = normal;
  gl_Position = projection * view * vec4(position, 1);
  gl_Position.xy += gl_Position.w * aside;
}
