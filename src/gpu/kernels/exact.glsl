// Square roots and quotients that are rounded to the last bit. OpenGL lets a driver be wrong by a few units there, so the
// driver's value is only a guess, which whole numbers correct: these are exact everywhere. A number is m * 2^e with a whole
// m of 24 bits; what the guess leaves over, such as m - guess^2, is small, so that its lowest 32 bits are all of it.

const uint hidden = 0x800000u;  // the bit of a fraction that a float leaves out

int exponentOf(uint bits) { return int((bits >> 23) & 0xffu); }
uint fractionOf(uint bits) { return (bits & 0x7fffffu) | hidden; }
// The same fraction between 1 and 2.
float withoutExponent(uint fraction) { return uintBitsToFloat(0x3f800000u | (fraction & 0x7fffffu)); }

int wholeNear(float a) { return int(floor(a + 0.5)); }

// Of a number >= 0. The guess is put right by as many units as the rest is worth, about, and then by one more at most.
float exactRoot(float a) {
  uint bits = floatBitsToUint(a);
  if (bits == 0u || exponentOf(bits) == 255) return a;
  bool tiny = exponentOf(bits) == 0;
  if (tiny) bits = floatBitsToUint(a * 16777216.0);
  int exponent = exponentOf(bits) - 127;
  int odd = exponent & 1;
  uint fraction = fractionOf(bits);
  uint shifted = fraction << (23 + odd);  // its root is the fraction of the root, 2^23 to 2^24
  float guess = sqrt(withoutExponent(fraction) * float(1 + odd));
  uint root = uint(guess * 8388608.0 + 0.5);
  int rest = int(shifted - root * root);
  int units = wholeNear(float(rest) / float(2u * root));
  rest -= units * (2 * int(root) + units);
  root += uint(units);
  root += uint(int(rest > int(root)) - int(rest <= -int(root)));
  int halved = (exponent - odd) / 2 - (tiny ? 12 : 0);
  return uintBitsToFloat((uint(halved + 126) << 23) + root);
}

float exactQuotient(float a, float b) {
  uint above = floatBitsToUint(a), below = floatBitsToUint(b);
  int exponent = exponentOf(above) - exponentOf(below);
  bool ordinary = exponentOf(above) % 255 != 0 && exponentOf(below) % 255 != 0;
  uint numerator = fractionOf(above), denominator = fractionOf(below);
  int more = numerator < denominator ? 1 : 0;
  exponent -= more;
  // Nothing, what is not finite, and what hardly any cloth has: quotients below 1e-38 or above 1e38.
  if (!ordinary || exponent < -125 || exponent > 126) return a / b;
  uint shifted = numerator << (23 + more);
  float guess = withoutExponent(numerator) / withoutExponent(denominator);
  uint quotient = uint(guess * float(8388608 << more) + 0.5);
  int rest = int(shifted - quotient * denominator), whole = int(denominator);
  int units = wholeNear(float(rest) / float(whole));
  rest -= units * whole;
  quotient += uint(units);
  quotient += uint(int(2 * rest > whole) - int(2 * rest < -whole));
  return uintBitsToFloat(((above ^ below) & 0x80000000u) | ((uint(exponent + 126) << 23) + quotient));
}
