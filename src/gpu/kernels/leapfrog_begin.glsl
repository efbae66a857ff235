// Leapfrog, the begin of a step, from the force that the last one kept: v += kick F; x += h v; and the velocity that
// damping sees. No force is evaluated, and each particle changes its own numbers alone.

#include "in_float.glsl"
#include "fields.glsl"

layout(std430, binding = 4) writeonly buffer NextVelocity { float nextVelocity[]; };
layout(std430, binding = 5) buffer OwnPosition { float ownPosition[]; };
layout(std430, binding = 6) buffer OwnVelocity { float ownVelocity[]; };
layout(std430, binding = 7) readonly buffer Force { float force[]; };

void main() {
  int c = int(gl_GlobalInvocationID.x), r = int(gl_GlobalInvocationID.y);
  if (c >= columns || r >= rows) return;
  for (int axis = 0; axis < 3; ++axis) {
    int i = axis * plane + r * stride + c;
    precise float v = ownVelocity[i] + kick * force[i];
    precise float x = ownPosition[i] + stepLength * v;
    precise float seen = v + kick * force[i];
    ownVelocity[i] = v;
    ownPosition[i] = x;
    nextVelocity[i] = seen;
  }
}
