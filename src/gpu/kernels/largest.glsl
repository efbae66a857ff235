// The square of the largest speed, and that of the length of the longest structural spring that is there. Numbers that are
// not negative are compared as whole numbers in the same order, because OpenGL has no atomic operation on others.

#include "in_float.glsl"
#include "fields.glsl"

layout(std430, binding = 3) buffer Largest { uint largest[2]; };

shared uint largestOfGroup[2];

// What is not a number is not the largest.
void look(int which, float squared) {
  if (squared >= 0.0) atomicMax(largestOfGroup[which], floatBitsToUint(squared));
}

void lookAtSpring(int a, int b) {
  precise vec3 d = positionAt(b) - positionAt(a);
  look(1, dotOf(d, d));
}

void main() {
  int c = int(gl_GlobalInvocationID.x), r = int(gl_GlobalInvocationID.y);
  uint thread = gl_LocalInvocationIndex;
  if (thread < 2u) largestOfGroup[thread] = 0u;
  barrier();
  if (c < columns && r < rows) {
    int a = r * stride + c;
    look(0, dotOf(velocityAt(a), velocityAt(a)));
    if (c + 1 < columns && isThere(a, rightBit)) lookAtSpring(a, a + 1);
    if (r + 1 < rows && isThere(a, downBit)) lookAtSpring(a, a + stride);
  }
  barrier();
  if (thread < 2u) atomicMax(largest[thread], largestOfGroup[thread]);
}
