// One pass over the sheet: the force on each particle, and what UPDATE makes of it. A pass reads where all particles are
// and writes somewhere else where they are next; only numbers that no neighbour reads are changed in place.

#include "in_float.glsl"
#include "fields.glsl"
#include "exact.glsl"
#include "springs.glsl"
#include "air.glsl"
#include "contact.glsl"
#include "force.glsl"

layout(std430, binding = 3) writeonly buffer NextPosition { float nextPosition[]; };
layout(std430, binding = 4) writeonly buffer NextVelocity { float nextVelocity[]; };
layout(std430, binding = 5) buffer OwnPosition { float ownPosition[]; };  // read and written by their particle alone
layout(std430, binding = 6) buffer OwnVelocity { float ownVelocity[]; };
layout(std430, binding = 7) buffer Force { float force[]; };
layout(std430, binding = 8) buffer SumOfVelocities { float sumOfVelocities[]; };
layout(std430, binding = 9) readonly buffer Pushes { uint pushes[]; };  // particle, x, y, z of each, by particle
layout(std430, binding = 10) writeonly buffer PinForces { float pinForces[]; };

uniform int pushCount, pinBase;
uniform vec3 weight;  // N
uniform float drag;   // N s/m
uniform float zero;   // 0, which no driver knows to be 0

// The pushes on the particle at `a`, one after the other.
vec3 withPushes(vec3 given, int a) {
  int first = 0, end = pushCount;
  while (first < end) {
    int middle = (first + end) / 2;
    if (int(pushes[4 * middle]) < a) first = middle + 1;
    else end = middle;
  }
  precise vec3 f = given;
  for (; first < pushCount && int(pushes[4 * first]) == a; ++first) {
    int at = 4 * first;
    f = f + vec3(uintBitsToFloat(pushes[at + 1]), uintBitsToFloat(pushes[at + 2]), uintBitsToFloat(pushes[at + 3]));
  }
  return f;
}

// On a particle that is free. A pin that moves feels the same but for contact and pushes; what it feels is not used but
// for the power that it brings.
vec3 forceOn(int a, ivec2 here, bool isFree) {
  vec3 x = positionAt(a), v = velocityAt(a);
  precise vec3 f = sheetForce(here, x, v);
#if CONTACT
  if (isFree) f = withContact(f, x, v);
#endif
  f = f + weight;
  f = f - drag * v;
  if (isFree) f = withPushes(f, a);
  return f;
}

#define READ(field, i) vec3(field[i], field[plane + i], field[2 * plane + i])
#define WRITE(field, i, v) field[i] = (v).x, field[plane + i] = (v).y, field[2 * plane + i] = (v).z

void update(int a, vec3 f) {
#if UPDATE == 0  // the force alone
  WRITE(force, a, f);
#elif UPDATE == 1  // symplectic Euler: v += kick F; x += h v
  precise vec3 v = velocityAt(a) + kick * f;
  precise vec3 x = positionAt(a) + stepLength * v;
  WRITE(nextVelocity, a, v);
  WRITE(nextPosition, a, x);
#elif UPDATE == 2  // leapfrog, between two steps: two half kicks, x += h v, and the velocity that damping sees next
  precise vec3 once = READ(ownVelocity, a) + kick * f;
  precise vec3 v = once + kick * f;
  precise vec3 x = positionAt(a) + stepLength * v;
  precise vec3 seen = v + kick * f;
  WRITE(ownVelocity, a, v);
  WRITE(nextPosition, a, x);
  WRITE(nextVelocity, a, seen);
#elif UPDATE == 3  // leapfrog, the last half kick; the force is kept
  precise vec3 v = READ(ownVelocity, a) + kick * f;
  WRITE(ownVelocity, a, v);
  WRITE(force, a, f);
#elif UPDATE == 4  // Runge-Kutta: begins the sums, and makes the first stage
  precise vec3 v = velocityAt(a);
  precise vec3 stageX = positionAt(a) + stepLength * v;
  precise vec3 stageV = v + kick * f;
  WRITE(sumOfVelocities, a, v);
  WRITE(force, a, f);
  WRITE(nextPosition, a, stageX);
  WRITE(nextVelocity, a, stageV);
#elif UPDATE == 5  // Runge-Kutta: adds to the sums, and makes the next stage
  vec3 here = velocityAt(a);
  precise vec3 sumV = READ(sumOfVelocities, a) + 2.0 * here;
  precise vec3 sumF = READ(force, a) + 2.0 * f;
  precise vec3 stageX = READ(ownPosition, a) + stepLength * here;
  precise vec3 stageV = READ(ownVelocity, a) + kick * f;
  WRITE(sumOfVelocities, a, sumV);
  WRITE(force, a, sumF);
  WRITE(nextPosition, a, stageX);
  WRITE(nextVelocity, a, stageV);
#else  // Runge-Kutta: the step
  precise vec3 sumV = READ(sumOfVelocities, a) + velocityAt(a);
  precise vec3 sumF = READ(force, a) + f;
  precise vec3 x = READ(ownPosition, a) + stepLength * sumV;
  precise vec3 v = READ(ownVelocity, a) + kick * sumF;
  WRITE(ownPosition, a, x);
  WRITE(ownVelocity, a, v);
#endif
}

void main() {
  int c = int(gl_GlobalInvocationID.x), r = int(gl_GlobalInvocationID.y);
  if (c >= columns || r >= rows) return;
  int a = r * stride + c;
  uint kind = kinds[a];
  bool isFree = (kind & pinBit) == 0u;
  int moving = int(kind >> movingShift);
  precise vec3 f = forceOn(a, ivec2(c, r), isFree);
  if (moving > 0) {
    int at = 3 * (pinBase + moving - 1);
    pinForces[at] = f.x, pinForces[at + 1] = f.y, pinForces[at + 2] = f.z;
    f = vec3(0);
  } else if (!isFree) {
    f = zero * f;  // as the processor does: where the force is infinite, the pin is lost too
  }
  update(a, f);
}
