// What the air does to a cell, by the operations of the processor's AirTerm and in their order. The winds of each moment,
// which the host works out, are steady ones and gusts.

#if AIR
layout(std430, binding = 11) readonly buffer Gusts { real gusts[]; };  // of all moments: amplitude, wave, phase, seven each
uniform int firstGust, endGust;
uniform real3 steadyWind;           // m/s
uniform real airFactor, tinyArea;  // kg/m3, m4

// The whole number next to one that is far below 2^22: only whole parts are left of a sum with WHOLE, 1.5 over epsilon.
real nearestWhole(real a) {
  precise real shifted = a + WHOLE;
  precise real whole = shifted - WHOLE;
  return whole;
}

real3 gustAt(int first, real3 at) {
  real3 amplitude = real3(gusts[first], gusts[first + 1], gusts[first + 2]);
  real3 wave = real3(gusts[first + 3], gusts[first + 4], gusts[first + 5]);
  precise real p = gusts[first + 6] - dotOf(wave, at);
  precise real q = 1.0 - 2.0 * abs(p - nearestWhole(p));
  precise real q2 = q * q;
  precise real inner = (35.0 - 84.0 * q) + q2 * (70.0 - 20.0 * q);
  precise real s = 2.0 * ((q2 * q2) * inner) - 1.0;
  precise real3 gust = s * amplitude;
  return gust;
}

real3 meanOf(real3 here, real3 right, real3 below, real3 belowRight) {
  precise real3 mean = 0.25 * ((here + right) + (below + belowRight));
  return mean;
}

struct AirOnCell {
  real3 corner;      // force on each corner, N
  real3 wind, past;  // the wind there, and the velocity at which it passes the cell, m/s
};

// Of the cell right and below of a particle.
AirOnCell airOnCell(int a) {
  int below = a + stride;
  real3 here = positionAt(a), right = positionAt(a + 1), under = positionAt(below), across = positionAt(below + 1);
  precise real3 wind = steadyWind;
  if (firstGust != endGust) {
    precise real3 centre = meanOf(here, right, under, across);
    for (int gust = firstGust; gust != endGust; ++gust) wind = wind + gustAt(7 * gust, centre);
  }
  precise real3 past = wind - meanOf(velocityAt(a), velocityAt(a + 1), velocityAt(below), velocityAt(below + 1));
  precise real3 downwards = across - here;
  precise real3 leftwards = under - right;
  precise real3 twiceArea = crossOf(downwards, leftwards);
  precise real squaredArea = dotOf(twiceArea, twiceArea) + tinyArea;
  precise real ratio = exactQuotient(dotOf(past, past), squaredArea);
  precise real factor = airFactor * (dotOf(past, twiceArea) * exactRoot(ratio));
  precise real3 corner = factor * twiceArea;
  return AirOnCell(corner, wind, past);
}

#endif
