// A solid thing in the scene. Its depth is that of a surface a little farther inside, so that the lines of a cloth that
// lies on it are in front of it all over.
#version 330 core

layout(location = 0) in vec3 position;  // in the thing's own axes, m
layout(location = 1) in vec3 normal;    // there, of unit length
uniform mat4 model;                     // from there to the world's
uniform mat4 view;
uniform mat4 projection;
uniform vec3 eye;                       // m
uniform float swell;                    // pixels that the surface is drawn farther out
uniform float focal;                    // pixels per metre at a distance of one metre
uniform float sink;                     // m from the surface inward to where lines are hidden

out vec3 point;   // in the world, m
out vec3 facing;  // the normal in the world's axes

const float kSteepest = 0.15;  // the least share of the normal in the line of sight: at the outline there is none

void main() {
  vec4 place = model * vec4(position, 1);
  point = place.xyz;
  facing = mat3(model) * normal;
  place.xyz -= facing * swell * (view * place).z / focal;
  vec3 toEye = eye - place.xyz;
  float away = length(toEye);
  float slant = max(abs(dot(facing, toEye)) / away, kSteepest);
  vec4 seen = view * place;
  gl_Position = projection * seen;
  vec4 deeper = projection * vec4(seen.xyz * (1 + sink / (slant * away)), 1);
  gl_Position.z = deeper.z / deeper.w * gl_Position.w;
}
