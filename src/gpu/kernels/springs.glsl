// The force of one spring on a particle at x with the velocity v, from the particle at the other end. The operations are
// those of the processor's springForce() and in their order; seen from the other end all signs change, and no bit else.

vec3 springForce(vec3 x, vec3 v, int other, vec3 law) {
  precise vec3 d = positionAt(other) - x;
  precise float squared = dotOf(d, d) + 1e-30;
  precise float inverseLength = exactQuotient(1.0, exactRoot(squared));
  precise float pull = law.x - law.y * inverseLength;
#if DAMPING == 0
  precise vec3 force = pull * d;
#elif DAMPING == 1
  precise vec3 dv = velocityAt(other) - v;
  precise vec3 force = pull * d + law.z * dv;
#else
  precise vec3 dv = velocityAt(other) - v;
  precise float along = law.z * ((dotOf(dv, d) * inverseLength) * inverseLength);
  precise float both = pull + along;
  precise vec3 force = both * d;
#endif
  return force;
}
