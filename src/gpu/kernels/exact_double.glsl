// Square roots and quotients of doubles that are rounded to the last bit, as exact.glsl has them for floats. The driver's
// value is put right by what it leaves over, and that is worked out exactly (Dekker 1971). Hardly any cloth has numbers
// below 1e-280 or above 1e280: for these the driver's value stands.

// A product, and what its rounding has left out.
dvec2 exactProduct(double a, double b) {
  const double splitter = 134217729.0lf;  // 2^27 + 1
  precise double wideA = splitter * a, wideB = splitter * b;
  precise double highA = wideA - (wideA - a), highB = wideB - (wideB - b);
  precise double lowA = a - highA, lowB = b - highB;
  precise double product = a * b;
  precise double rest = ((highA * highB - product) + highA * lowB + lowA * highB) + lowA * lowB;
  return dvec2(product, rest);
}

bool isOrdinary(double a) { return abs(a) > 1e-280lf && abs(a) < 1e280lf; }

// Of a number and a guess that is a few units off at most. A second time it is right also where the root lies beside the
// middle between two numbers, which the square of the first guess' error hides.
double betterRoot(double a, double guess) {
  dvec2 square = exactProduct(guess, guess);
  precise double rest = (a - square.x) - square.y;
  precise double root = guess + rest / (2.0lf * guess);
  return root;
}

double exactRoot(double a) {
  precise double guess = sqrt(a);
  return isOrdinary(a) ? betterRoot(a, betterRoot(a, guess)) : guess;
}

double exactQuotient(double a, double b) {
  precise double guess = a / b;
  if (!isOrdinary(guess) || !isOrdinary(b)) return guess;
  dvec2 product = exactProduct(guess, b);
  precise double rest = (a - product.x) - product.y;
  precise double quotient = guess + rest / b;
  return quotient;
}
