// The force of the air on each corner of a cell, by the operations of the processor's AirTerm and in their order. The
// winds of each moment, which the host works out, are steady ones and gusts.

#if AIR
layout(std430, binding = 11) readonly buffer Gusts { float gusts[]; };  // of all moments: amplitude, wave, phase, seven each
uniform int firstGust, endGust;
uniform vec3 steadyWind;               // m/s
uniform float airFactor, tinyArea;     // kg/m3, m4

// The whole number next to one that is far below 2^22: only whole parts are left of a sum with 1.5 * 2^23.
float nearestWhole(float a) {
  precise float shifted = a + 12582912.0;
  precise float whole = shifted - 12582912.0;
  return whole;
}

vec3 gustAt(int first, vec3 at) {
  vec3 amplitude = vec3(gusts[first], gusts[first + 1], gusts[first + 2]);
  vec3 wave = vec3(gusts[first + 3], gusts[first + 4], gusts[first + 5]);
  precise float p = gusts[first + 6] - dotOf(wave, at);
  precise float q = 1.0 - 2.0 * abs(p - nearestWhole(p));
  precise float q2 = q * q;
  precise float inner = (35.0 - 84.0 * q) + q2 * (70.0 - 20.0 * q);
  precise float s = 2.0 * ((q2 * q2) * inner) - 1.0;
  precise vec3 gust = s * amplitude;
  return gust;
}

vec3 meanOf(vec3 here, vec3 right, vec3 below, vec3 belowRight) {
  precise vec3 mean = 0.25 * ((here + right) + (below + belowRight));
  return mean;
}

// Of the cell right and below of a particle.
vec3 cornerForce(int a) {
  int below = a + stride;
  vec3 here = positionAt(a), right = positionAt(a + 1), under = positionAt(below), across = positionAt(below + 1);
  precise vec3 wind = steadyWind;
  if (firstGust != endGust) {
    precise vec3 centre = meanOf(here, right, under, across);
    for (int gust = firstGust; gust != endGust; ++gust) wind = wind + gustAt(7 * gust, centre);
  }
  precise vec3 past = wind - meanOf(velocityAt(a), velocityAt(a + 1), velocityAt(below), velocityAt(below + 1));
  precise vec3 downwards = across - here;
  precise vec3 leftwards = under - right;
  precise vec3 twiceArea = crossOf(downwards, leftwards);
  precise float squaredArea = dotOf(twiceArea, twiceArea) + tinyArea;
  precise float ratio = exactQuotient(dotOf(past, past), squaredArea);
  precise float factor = airFactor * (dotOf(past, twiceArea) * exactRoot(ratio));
  precise vec3 corner = factor * twiceArea;
  return corner;
}

#endif
