// Where all particles are, for whoever draws them: x, y, z of one after the other, and the least and the largest of each.
// These are compared as whole numbers in the same order, because OpenGL has no atomic operation on others.

#include "in_float.glsl"
#include "fields.glsl"

layout(std430, binding = 3) writeonly buffer Gathered { float xyz[]; };
layout(std430, binding = 4) buffer Extremes { uint extremes[6]; };

shared uint groupExtremes[6];  // of this work group: the least x, y, z, and the largest

// Numbers that are not finite are beyond all others.
uint inOrder(float a) {
  uint bits = floatBitsToUint(a);
  return (bits & 0x80000000u) == 0u ? bits | 0x80000000u : ~bits;
}

void main() {
  int c = int(gl_GlobalInvocationID.x), r = int(gl_GlobalInvocationID.y);
  uint thread = gl_LocalInvocationIndex;
  if (thread < 6u) groupExtremes[thread] = thread < 3u ? 0xffffffffu : 0u;
  barrier();
  if (c < columns && r < rows) {
    vec3 x = positionAt(r * stride + c);
    for (int axis = 0; axis < 3; ++axis) {
      xyz[3 * (r * columns + c) + axis] = x[axis];
      atomicMin(groupExtremes[axis], inOrder(x[axis]));
      atomicMax(groupExtremes[axis + 3], inOrder(x[axis]));
    }
  }
  barrier();
  if (thread < 3u) atomicMin(extremes[thread], groupExtremes[thread]);
  else if (thread < 6u) atomicMax(extremes[thread], groupExtremes[thread]);
}
