// What all passes see: the fields of the sheet, a plane of numbers per component with `plane` numbers from one to the
// next. `real` is what a program computes in, float or double; the fields are float.

layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 0) readonly buffer Position { float position[]; };
layout(std430, binding = 1) readonly buffer Velocity { float velocity[]; };  // the one that damping sees
layout(std430, binding = 2) readonly buffer Kinds { uint kinds[]; };

uniform int columns, rows, stride, plane;
uniform float stepLength, kick;  // s, s/kg

// Of a kind: what of the sheet is gone, as tyg::Missing has it; whether the particle is a pin; and above these bits, of a
// pin that moves, its place in the list of those, counted from 1.
const uint rightBit = 1u, downBit = 2u, downRightBit = 4u, downLeftBit = 8u, right2Bit = 16u, down2Bit = 32u,
           cellBit = 64u, pinBit = 128u;
const int movingShift = 8;

vec3 positionAt(int i) { return vec3(position[i], position[plane + i], position[2 * plane + i]); }
vec3 velocityAt(int i) { return vec3(velocity[i], velocity[plane + i], velocity[2 * plane + i]); }

// Whether a spring or a cell of the particle `owner`, for which the sheet has room, is still there.
bool isThere(int owner, uint bit) {
#if CUT
  return (kinds[owner] & bit) == 0u;
#else
  return true;
#endif
}

// Each operation is to round as it stands: `precise` forbids the driver to join a product and a sum.
real dotOf(real3 a, real3 b) {
  precise real sum = (a.x * b.x + a.y * b.y) + a.z * b.z;
  return sum;
}

real3 crossOf(real3 a, real3 b) {
  precise real3 product = real3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  return product;
}
