// The force on one particle. It is gathered from the springs and cells around it, so that no particle waits for another,
// and summed in the order in which the processor's accumulateRow() sums what its rows scatter: that gives the same bits.
// An addition of zero, which the processor has where a spring is not there, changes no finite number and is left out.

uniform vec3 structural, shear, bend;  // ks, N/m; ks times the length at rest, N; kd, N s/m

// The springs at a particle in that order: the columns and rows to their other end, their family (structural, shear,
// bend), the columns and rows to the particle that they belong to, and their bit there.
const int springCount = 12;
const ivec2 ends[springCount] =
    ivec2[springCount](ivec2(1, 0), ivec2(0, -2), ivec2(0, -1), ivec2(1, -1), ivec2(0, 1), ivec2(1, 1), ivec2(2, 0),
                       ivec2(0, 2), ivec2(-1, 1), ivec2(-1, 0), ivec2(-1, -1), ivec2(-2, 0));
const int families[springCount] = int[springCount](0, 2, 0, 1, 0, 1, 2, 2, 1, 0, 1, 2);
const ivec2 owners[springCount] =
    ivec2[springCount](ivec2(0, 0), ivec2(0, -2), ivec2(0, -1), ivec2(0, -1), ivec2(0, 0), ivec2(0, 0), ivec2(0, 0),
                       ivec2(0, 0), ivec2(-1, 0), ivec2(-1, 0), ivec2(-1, -1), ivec2(-2, 0));
const uint bits[springCount] = uint[springCount](rightBit, down2Bit, downBit, downLeftBit, downBit, downRightBit,
                                                 right2Bit, down2Bit, downLeftBit, rightBit, downRightBit, right2Bit);
// Springs 1 to 3 come from the rows above, 8 and 9 from the particle to the left: each of these two groups is summed by
// itself first. The cells above, below right, below left and above left join springs 2, 7, 9 and 10.
const int above = 2, lastFromAbove = 3, lastOwn = 7, left = 9, aboveLeft = 10;

bool isInside(ivec2 place) { return all(greaterThanEqual(place, ivec2(0))) && place.x < columns && place.y < rows; }
int indexOf(ivec2 place) { return place.y * stride + place.x; }

// Of the spring k; zero where it is not there.
vec3 forceOfSpring(int k, ivec2 here, vec3 x, vec3 v) {
  int family = families[k];
  bool modelled = family == 0 ? STRUCTURAL == 1 : family == 1 ? SHEAR == 1 : BEND == 1;
  ivec2 other = here + ends[k];
  if (!modelled || !isInside(other) || !isThere(indexOf(here + owners[k]), bits[k])) return vec3(0);
  return springForce(x, v, indexOf(other), family == 0 ? structural : family == 1 ? shear : bend);
}

#if AIR
// Of the cell below right of the owner of spring k; zero where no cell joins this spring.
vec3 cornerBeside(int k, ivec2 here) {
  ivec2 owner = here + owners[k];
  bool joins = k == above || k == lastOwn || k == left || k == aboveLeft;
  if (!joins || !isInside(owner) || !isInside(owner + ivec2(1)) || !isThere(indexOf(owner), cellBit)) return vec3(0);
  return airOnCell(indexOf(owner)).corner;
}
#endif

// Without contact, weight and what is done to single particles.
vec3 sheetForce(ivec2 here, vec3 x, vec3 v) {
  precise vec3 f = vec3(0), group = vec3(0);
  for (int k = 0; k < springCount; ++k) {
    precise vec3 one = forceOfSpring(k, here, x, v);
#if AIR
    precise vec3 corner = cornerBeside(k, here);
    if (k == above || k == aboveLeft) one = one + corner;
#endif
    bool grouped = (k >= 1 && k <= lastFromAbove) || k == left - 1 || k == left;
    if (grouped) group = group + one;
    else f = f + one;
#if AIR
    if (k == lastOwn) f = f + corner;
    if (k == left) group = group + corner;
#endif
    if (k == lastFromAbove || k == left) {
      f = f + group;
      group = vec3(0);
    }
  }
  return f;
}
