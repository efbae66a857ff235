// The energies of each row, or the power in it, as the processor's row_energy.h has them: in double, with the same
// operations, in eight running sums, particle by particle, which are added in pairs at the end. A work group has sixteen
// rows, and a thread one running sum of one of them.

#include "in_double.glsl"
#include "fields.glsl"
#include "exact_double.glsl"
#include "air.glsl"
#include "contact.glsl"

layout(std430, binding = 3) writeonly buffer Rows { double ofRows[]; };

uniform int firstRow;  // where these sums begin, in rows
uniform dvec3 structural, shear, bend;  // ks, N/m; the length at rest, m; kd, N s/m

const int sumCount = 8, rowsOfGroup = 16;
shared double parts[sumCount * rowsOfGroup];

int row, sumIndex;

// All threads of a group call these together.
double addedUp(double part) {
  int me = int(gl_LocalInvocationIndex), first = me - sumIndex;
  parts[me] = part;
  barrier();
  precise double sum = ((parts[first] + parts[first + 1]) + (parts[first + 2] + parts[first + 3])) +
                       ((parts[first + 4] + parts[first + 5]) + (parts[first + 6] + parts[first + 7]));
  barrier();
  return sum;
}
double largestOf(double part) {
  int me = int(gl_LocalInvocationIndex), first = me - sumIndex;
  parts[me] = part;
  barrier();
  double largest = parts[first];
  for (int k = 1; k < sumCount; ++k) largest = max(largest, parts[first + k]);
  barrier();
  return largest;
}

// Springs of one family from the particles of the row, n of them: from which column on, to which other end, and the bit.
struct Run {
  dvec3 law;
  int begin, right, down, count;
  uint bit;
};
const int runCount = 6;
Run runOf(int k) {
  bool below = row + 1 < rows, twoBelow = row + 2 < rows;
  if (k == 0) return Run(structural, 0, 1, 0, row < rows ? columns - 1 : 0, rightBit);
  if (k == 1) return Run(structural, 0, 0, 1, below ? columns : 0, downBit);
  if (k == 2) return Run(shear, 0, 1, 1, below ? columns - 1 : 0, downRightBit);
  if (k == 3) return Run(shear, 1, -1, 1, below ? columns - 1 : 0, downLeftBit);
  if (k == 4) return Run(bend, 0, 2, 0, row < rows ? columns - 2 : 0, right2Bit);
  return Run(bend, 0, 0, 2, twoBelow ? columns : 0, down2Bit);
}

dvec3 positionOf(int i) { return dvec3(positionAt(i)); }
dvec3 velocityOf(int i) { return dvec3(velocityAt(i)); }
int columnsOfRow() { return row < rows ? columns : 0; }

#if ENERGY

const int numbersOfRow = 5;  // kinetic, elastic, gravitational and in contact, J; the largest stretch
uniform double mass, contactScale;  // kg; N m
uniform dvec3 weight;               // N

#if CONTACT
const double oneSeventh = 0.14285714285714285lf;  // the number next to it

// P(u) of the model.
double potential(double u) {
  double c = clamped(u);
  precise double square = c * c, beyond = max(u, 0.0lf) - c;
  precise double within = (square * square * c) * (0.5lf - 0.5lf * c + oneSeventh * square);
  precise double whole = within + 0.5lf * (beyond + beyond * beyond);
  return whole;
}

double inContact(int solid) {
  precise double sum = 0.0lf;
  for (int k = sumIndex; k < columnsOfRow(); k += sumCount) {
    int i = row * stride + k;
    dvec3 normal;
    precise double below = depthIn(solid, positionOf(i), normal);
    if ((kinds[i] & pinBit) == 0u && below > 0.0lf) sum = sum + potential(perLayer * below);
  }
  return sum;
}
#endif

void main() {
  sumIndex = int(gl_LocalInvocationIndex) % sumCount;
  row = int(gl_WorkGroupID.y) * rowsOfGroup + int(gl_LocalInvocationIndex) / sumCount;
  precise double moving = 0.0lf, height = 0.0lf;
  for (int k = sumIndex; k < columnsOfRow(); k += sumCount) {
    int i = row * stride + k;
    dvec3 x = positionOf(i), v = velocityOf(i);
    moving = moving + dotOf(v, v);
    height = height + dotOf(weight, x);
  }
  precise double kinetic = (0.5lf * addedUp(moving)) * mass;
  double gravitational = -addedUp(height);

  precise double contact = 0.0lf;
#if CONTACT
  for (int body = firstSolid; body < endSolid; ++body) contact = contact + addedUp(inContact(solidSize * body));
  contact = contactScale * contact;
#endif

  precise double elastic = 0.0lf;
  double stretch = 0.0lf;
  for (int which = 0; which < runCount; ++which) {
    Run run = runOf(which);
    precise double sum = 0.0lf;
    double longest = 0.0lf;
    for (int k = sumIndex; k < run.count; k += sumCount) {
      int a = row * stride + run.begin + k;
      precise dvec3 d = positionOf(a + run.down * stride + run.right) - positionOf(a);
      precise double elongation = exactRoot(dotOf(d, d)) - run.law.y;
      if (!isThere(row * stride + k, run.bit)) elongation = 0.0lf;
      if (elongation > longest) longest = elongation;
      sum = sum + (0.5lf * run.law.x) * elongation * elongation;
    }
    precise double energy = addedUp(sum);
    if (!(run.law.x > 0.0lf || run.law.z > 0.0lf)) continue;
    elastic = elastic + energy;
    stretch = max(stretch, exactQuotient(longest, run.law.y));
  }
  stretch = largestOf(stretch);

  if (sumIndex != 0 || row >= rows) return;
  int at = numbersOfRow * (firstRow + row);
  ofRows[at] = kinetic, ofRows[at + 1] = elastic, ofRows[at + 2] = gravitational, ofRows[at + 3] = contact;
  ofRows[at + 4] = stretch;
}

#else

const int numbersOfRow = 3;  // lost, brought by wind and by bodies, W
uniform double drag;         // N s/m

#if AIR
dvec2 ofAir() {
  precise dvec2 sum = dvec2(0);
  int cells = row + 1 < rows ? columns - 1 : 0;
  for (int k = sumIndex; k < cells; k += sumCount) {
    int a = row * stride + k;
    if (!isThere(a, cellBit)) continue;
    AirOnCell air = airOnCell(a);
    precise dvec2 both = 4.0lf * dvec2(dotOf(air.corner, air.past), dotOf(air.corner, air.wind));
    sum = sum + both;
  }
  return sum;
}
#endif

#if CONTACT
dvec2 ofContact(int solid) {
  precise dvec2 sum = dvec2(0);
  for (int k = sumIndex; k < columnsOfRow(); k += sumCount) {
    int i = row * stride + k;
    dvec3 normal;
    precise double below = depthIn(solid, positionOf(i), normal);
    if ((kinds[i] & pinBit) != 0u || !(below > 0.0lf)) continue;
    Touch touch = touchAt(below, normal, solid, velocityOf(i));
    precise double lost = touch.damping * touch.approach * touch.approach + touch.friction * dotOf(touch.slide, touch.slide);
    sum = sum + dvec2(lost, dotOf(forceOf(touch), at3(solid + 9)));
  }
  return sum;
}
#endif

// What the damping of springs takes, but for its factor kd.
double dampedIn(Run run) {
  precise double sum = 0.0lf;
  for (int k = sumIndex; k < run.count; k += sumCount) {
    int a = row * stride + run.begin + k, b = a + run.down * stride + run.right;
    if (!isThere(row * stride + k, run.bit)) continue;
    precise dvec3 dv = velocityOf(b) - velocityOf(a);
#if AXIAL
    precise dvec3 d = positionOf(b) - positionOf(a);
    precise double along = dotOf(dv, d);
    precise double squared = dotOf(d, d) + 1e-300lf;
    sum = sum + exactQuotient(along * along, squared);
#else
    sum = sum + dotOf(dv, dv);
#endif
  }
  return sum;
}

void main() {
  sumIndex = int(gl_LocalInvocationIndex) % sumCount;
  row = int(gl_WorkGroupID.y) * rowsOfGroup + int(gl_LocalInvocationIndex) / sumCount;
  precise double dragged = 0.0lf;
  for (int k = sumIndex; k < columnsOfRow(); k += sumCount) {
    dvec3 v = velocityOf(row * stride + k);
    dragged = dragged + dotOf(v, v);
  }
  precise double speeds = addedUp(dragged), lost = 0.0lf;
  if (drag > 0.0lf) lost = drag * speeds;
  double wind = 0.0lf;
#if AIR
  dvec2 air = ofAir();
  lost = lost + addedUp(air.x);
  wind = addedUp(air.y);
#endif
  precise dvec2 touching = dvec2(0);
#if CONTACT
  for (int body = firstSolid; body < endSolid; ++body) {
    dvec2 one = ofContact(solidSize * body);
    touching = touching + dvec2(addedUp(one.x), addedUp(one.y));
  }
#endif
  lost = lost + touching.x;
  for (int which = 0; which < runCount; ++which) {
    Run run = runOf(which);
    precise double damped = addedUp(dampedIn(run));
    if (run.law.z > 0.0lf) lost = lost + run.law.z * damped;
  }

  if (sumIndex != 0 || row >= rows) return;
  int at = numbersOfRow * (firstRow + row);
  ofRows[at] = lost, ofRows[at + 1] = wind, ofRows[at + 2] = touching.y;
}

#endif
