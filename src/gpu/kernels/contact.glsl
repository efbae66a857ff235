// What bodies do to a particle, by the operations of the processor's ContactTerm and in their order. A body that a
// particle does not touch adds nothing.

#if CONTACT
layout(std430, binding = 12) readonly buffer Solids { float solids[]; };  // of all moments, twelve numbers each:
const int solidSize = 12;  // shape, at, axis, one over the axis' squared length, radius, velocity
uniform int firstSolid, endSolid;
uniform float contactForce, perLayer, contactDamping, friction, slip;

const float tiny = 1e-30;

float number(int i) { return solids[i]; }
vec3 at3(int i) { return vec3(solids[i], solids[i + 1], solids[i + 2]); }
float clamped(float a) { return min(max(a, 0.0), 1.0); }

// S(u) of the model.
float smoothStep(float u) {
  float c = clamped(u);
  precise float square = c * c;
  precise float step = (square * square) * ((c - 3.0) * c + 2.5) + (max(u, 0.0) - c);
  return step;
}

float depthInBall(float radius, vec3 from, out vec3 normal) {
  precise float distance = exactRoot(dotOf(from, from) + tiny);
  precise vec3 outwards = exactQuotient(1.0, distance) * from;
  precise float below = radius - distance;
  normal = outwards;
  return below;
}

float depthInBox(float radius, vec3 half3, vec3 from, out vec3 normal) {
  vec3 side = vec3(from.x < 0.0 ? -1.0 : 1.0, from.y < 0.0 ? -1.0 : 1.0, from.z < 0.0 ? -1.0 : 1.0);
  precise vec3 beyond = side * from - half3;
  precise vec3 past = side * max(beyond, vec3(0));
  float most = max(max(beyond.x, beyond.y), beyond.z);
  precise float distance = exactRoot(dotOf(past, past) + tiny);
  // 1 for the axis of the nearest face, where the place is inside the core.
  float inside = 0.0 >= most ? 1.0 : 0.0;
  float x = inside * (beyond.x >= most ? 1.0 : 0.0);
  float y = (inside - x) * (beyond.y >= most ? 1.0 : 0.0);
  vec3 face = vec3(x, y, (inside - x) - y) * side;
  precise vec3 outwards = exactQuotient(1.0, distance) * past + face;
  precise float below = radius - (distance + min(most, 0.0));
  normal = outwards;
  return below;
}

float depthIn(int solid, vec3 place, out vec3 normal) {
  int shape = int(number(solid));
  vec3 at = at3(solid + 1), axis = at3(solid + 4);
  float radius = number(solid + 8);
  if (shape == 0) {
    precise float below = radius - dotOf(place, axis);
    normal = axis;
    return below;
  }
  precise vec3 from = place - at;
  if (shape == 3) return depthInBox(radius, axis, from, normal);
  if (shape == 2) {
    precise float share = number(solid + 7) * dotOf(from, axis);
    precise vec3 along = clamped(share) * axis;
    from = from - along;
  }
  return depthInBall(radius, from, normal);
}

// What acts against a motion along the normal (x) and along the surface (y), N s/m.
vec2 against(float s, float push, float squaredSlip) {
  precise float whole = s + 0.5;
  precise float damping = contactDamping * s;
  if (!(friction > 0.0)) return vec2(exactQuotient(damping, whole), 0.0);
  precise float slow = slip * push;
  precise float squared = (squaredSlip + slow * slow) + tiny;
  precise float speed = exactRoot(squared);
  precise float inverse = exactQuotient(1.0, whole * speed);
  precise vec2 both = vec2(damping * (speed * inverse), (friction * push) * (whole * inverse));
  return both;
}

// A level plane: its normal points straight up or down.
vec3 withFloor(vec3 f, int solid, vec3 place, vec3 velocity) {
  float up = number(solid + 5);
  precise float below = number(solid + 8) - up * place.y;
  if (!(below > 0.0)) return f;
  float s = smoothStep(perLayer * below);
  precise vec3 relative = velocity - at3(solid + 9);
  precise float push = contactForce * s;
  precise float squaredSlip = relative.x * relative.x + relative.z * relative.z;
  vec2 c = against(s, push, squaredSlip);
  precise float along = up * push - c.x * relative.y;
  precise vec2 across = c.y * relative.xz;
  precise vec3 sum = f + vec3(-across.x, along, -across.y);
  return sum;
}

vec3 withSolid(vec3 f, int solid, vec3 place, vec3 velocity) {
  vec3 normal;
  float below = depthIn(solid, place, normal);
  if (!(below > 0.0)) return f;
  float s = smoothStep(perLayer * below);
  precise vec3 relative = velocity - at3(solid + 9);
  precise float push = contactForce * s;
  precise float approach = dotOf(relative, normal);
  precise vec3 slide = vec3(0);
  if (friction > 0.0) slide = relative - approach * normal;
  vec2 c = against(s, push, dotOf(slide, slide));
  precise float along = push - c.x * approach;
  precise vec3 force = along * normal - c.y * slide;
  precise vec3 sum = f + force;
  return sum;
}

// The force f with that of all bodies added, one after the other.
vec3 withContact(vec3 f, vec3 place, vec3 velocity) {
  vec3 sum = f;
  for (int body = firstSolid; body < endSolid; ++body) {
    int solid = solidSize * body;
    bool isLevel = number(solid) == 0.0 && number(solid + 4) == 0.0 && number(solid + 6) == 0.0;
    sum = isLevel ? withFloor(sum, solid, place, velocity) : withSolid(sum, solid, place, velocity);
  }
  return sum;
}

#endif
