// What bodies do to a particle, by the operations of the processor's ContactTerm and in their order. A body that a
// particle does not touch adds nothing.

#if CONTACT
layout(std430, binding = 12) readonly buffer Solids { real solids[]; };  // of all moments, twelve numbers each:
const int solidSize = 12;  // shape, at, axis, one over the axis' squared length, radius, velocity
uniform int firstSolid, endSolid;
uniform real contactForce, perLayer, contactDamping, friction, slip;

real number(int i) { return solids[i]; }
real3 at3(int i) { return real3(solids[i], solids[i + 1], solids[i + 2]); }
real clamped(real a) { return min(max(a, 0.0), 1.0); }

// S(u) of the model.
real smoothStep(real u) {
  real c = clamped(u);
  precise real square = c * c;
  precise real step = (square * square) * ((c - 3.0) * c + 2.5) + (max(u, 0.0) - c);
  return step;
}

real depthInBall(real radius, real3 from, out real3 normal) {
  precise real distance = exactRoot(dotOf(from, from) + TINY);
  precise real3 outwards = exactQuotient(1.0, distance) * from;
  precise real below = radius - distance;
  normal = outwards;
  return below;
}

real depthInBox(real radius, real3 half3, real3 from, out real3 normal) {
  real3 side = real3(from.x < 0.0 ? -1.0 : 1.0, from.y < 0.0 ? -1.0 : 1.0, from.z < 0.0 ? -1.0 : 1.0);
  precise real3 beyond = side * from - half3;
  precise real3 past = side * max(beyond, real3(0));
  real most = max(max(beyond.x, beyond.y), beyond.z);
  precise real distance = exactRoot(dotOf(past, past) + TINY);
  // 1 for the axis of the nearest face, where the place is inside the core.
  real inside = 0.0 >= most ? 1.0 : 0.0;
  real x = inside * (beyond.x >= most ? 1.0 : 0.0);
  real y = (inside - x) * (beyond.y >= most ? 1.0 : 0.0);
  real3 face = real3(x, y, (inside - x) - y) * side;
  precise real3 outwards = exactQuotient(1.0, distance) * past + face;
  precise real below = radius - (distance + min(most, 0.0));
  normal = outwards;
  return below;
}

real depthIn(int solid, real3 place, out real3 normal) {
  int shape = int(number(solid));
  real3 at = at3(solid + 1), axis = at3(solid + 4);
  real radius = number(solid + 8);
  if (shape == 0) {
    precise real below = radius - dotOf(place, axis);
    normal = axis;
    return below;
  }
  precise real3 from = place - at;
  if (shape == 3) return depthInBox(radius, axis, from, normal);
  if (shape == 2) {
    precise real share = number(solid + 7) * dotOf(from, axis);
    precise real3 along = clamped(share) * axis;
    from = from - along;
  }
  return depthInBall(radius, from, normal);
}

// What acts against a motion along the normal (x) and along the surface (y), N s/m.
real2 against(real s, real push, real squaredSlip) {
  precise real whole = s + 0.5;
  precise real damping = contactDamping * s;
  if (!(friction > 0.0)) return real2(exactQuotient(damping, whole), 0.0);
  precise real slow = slip * push;
  precise real squared = (squaredSlip + slow * slow) + TINY;
  precise real speed = exactRoot(squared);
  precise real inverse = exactQuotient(1.0, whole * speed);
  precise real2 both = real2(damping * (speed * inverse), (friction * push) * (whole * inverse));
  return both;
}

// A level plane: its normal points straight up or down.
real3 withFloor(real3 f, int solid, real3 place, real3 velocity) {
  real up = number(solid + 5);
  precise real below = number(solid + 8) - up * place.y;
  if (!(below > 0.0)) return f;
  real s = smoothStep(perLayer * below);
  precise real3 relative = velocity - at3(solid + 9);
  precise real push = contactForce * s;
  precise real squaredSlip = relative.x * relative.x + relative.z * relative.z;
  real2 c = against(s, push, squaredSlip);
  precise real along = up * push - c.x * relative.y;
  precise real2 across = c.y * relative.xz;
  precise real3 sum = f + real3(-across.x, along, -across.y);
  return sum;
}

// What a body does to a particle that touches it.
struct Touch {
  real3 normal;            // out of the body
  real push;               // N, along the normal
  real approach;           // m/s, along the normal; negative: towards the body
  real3 slide;             // m/s, along the surface
  real damping, friction;  // N s/m, against the one and the other
};

Touch touchAt(real below, real3 normal, int solid, real3 velocity) {
  real s = smoothStep(perLayer * below);
  precise real3 relative = velocity - at3(solid + 9);
  precise real push = contactForce * s;
  precise real approach = dotOf(relative, normal);
  precise real3 slide = real3(0);
  if (friction > 0.0) slide = relative - approach * normal;
  real2 c = against(s, push, dotOf(slide, slide));
  return Touch(normal, push, approach, slide, c.x, c.y);
}

real3 forceOf(Touch touch) {
  precise real along = touch.push - touch.damping * touch.approach;
  precise real3 force = along * touch.normal - touch.friction * touch.slide;
  return force;
}

real3 withSolid(real3 f, int solid, real3 place, real3 velocity) {
  real3 normal;
  real below = depthIn(solid, place, normal);
  if (!(below > 0.0)) return f;
  precise real3 sum = f + forceOf(touchAt(below, normal, solid, velocity));
  return sum;
}

// The force f with that of all bodies added, one after the other.
real3 withContact(real3 f, real3 place, real3 velocity) {
  real3 sum = f;
  for (int body = firstSolid; body < endSolid; ++body) {
    int solid = solidSize * body;
    bool isLevel = number(solid) == 0.0 && number(solid + 4) == 0.0 && number(solid + 6) == 0.0;
    sum = isLevel ? withFloor(sum, solid, place, velocity) : withSolid(sum, solid, place, velocity);
  }
  return sum;
}

#endif
