// Square roots and quotients on the card are the processor's, to the last bit, also where a driver's own are a few
// units off.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "card_here.h"
#include "gpu/card.h"
#include "gpu/card_buffer.h"

namespace tyg {
namespace {

/// Roots and quotients of T, by the functions of `file`; each of the guesses there is off by some units in its last
/// place.
template <class T>
struct Exact;
template <>
struct Exact<float> {
  static constexpr const char* kFile = "exact.glsl";
  static constexpr const char* kGuesses[] = {"sqrt(withoutExponent(fraction) * float(1 + odd))",
                                             "withoutExponent(numerator) / withoutExponent(denominator)"};
  static constexpr const char* kSpoil =
      "float spoiled(float a) { return uintBitsToFloat(floatBitsToUint(a) + uint(OFF)); }\n";
  static constexpr int kMostUnits = 7;
};
template <>
struct Exact<double> {
  static constexpr const char* kFile = "exact_double.glsl";
  static constexpr const char* kGuesses[] = {"sqrt(a)", "a / b"};
  static constexpr const char* kSpoil = R"(
double spoiled(double a) {
  uvec2 halves = unpackDouble2x32(a);
  uint low = halves.x + uint(OFF);
  if (OFF > 0 && low < halves.x) ++halves.y;
  if (OFF < 0 && low > halves.x) --halves.y;
  return packDouble2x32(uvec2(low, halves.y));
}
)";
  static constexpr int kMostUnits = 3;
};

constexpr const char* kMain = R"(
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer A { real a[]; };
layout(std430, binding = 1) readonly buffer B { real b[]; };
layout(std430, binding = 2) writeonly buffer Roots { real roots[]; };
layout(std430, binding = 3) writeonly buffer Quotients { real quotients[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  roots[i] = exactRoot(a[i]);
  quotients[i] = exactQuotient(a[i], b[i]);
}
)";

template <class T>
std::string textWithGuessesOffBy(int units) {
  std::string exact = textOf(Exact<T>::kFile);
  for (const std::string_view guess : Exact<T>::kGuesses) {
    const std::size_t at = exact.find(guess);
    EXPECT_NE(at, std::string::npos) << guess;
    exact.replace(at, guess.size(), "spoiled(" + std::string(guess) + ")");
  }
  return "#version 430 core\n#define OFF " + std::to_string(units) + "\n#define real " +
         (sizeof(T) == sizeof(float) ? "float" : "double") + "\n" + Exact<T>::kSpoil + exact + kMain;
}

constexpr std::size_t kNumbers = 1 << 18;

/// Numbers of all sizes that a quotient of two leaves within the ordinary ones, and some beside powers of two.
template <class T>
std::vector<T> numbers(unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<T> all;
  for (std::size_t k = 0; k < kNumbers; ++k) {
    const int exponent = int(random() % 110) - 57;
    const T whole = T(random() >> (64 - std::numeric_limits<T>::digits + 1)), beside = T(int(random() % 8) - 4);
    const T epsilon = std::numeric_limits<T>::epsilon();
    all.push_back(std::ldexp(1 + epsilon * (k % 4 == 0 ? beside : whole), exponent));
  }
  return all;
}

template <class T>
struct OnCardResults {
  std::vector<T> roots = std::vector<T>(kNumbers), quotients = std::vector<T>(kNumbers);
};

template <class T>
OnCardResults<T> computed(Card& card, const std::vector<T>& a, const std::vector<T>& b, int units) {
  OnCardResults<T> results;
  card.run([&] {
    Kernel kernel(card.gl(), "exactness", textWithGuessesOffBy<T>(units));
    CardBuffer inA(card), inB(card), outRoots(card), outQuotients(card);
    const std::size_t bytes = kNumbers * sizeof(T);
    inA.write(a.data(), bytes), inB.write(b.data(), bytes), outRoots.reserve(bytes), outQuotients.reserve(bytes);
    inA.show(0), inB.show(1), outRoots.show(2), outQuotients.show(3);
    kernel.use();
    card.gl().DispatchCompute(kNumbers / 64, 1, 1);
    outRoots.read(results.roots.data(), bytes), outQuotients.read(results.quotients.data(), bytes);
    card.refuseErrors();
  });
  return results;
}

template <class T>
class Exactness : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(Exactness, Precisions);

TYPED_TEST(Exactness, HoldsForEveryNumberWhateverTheDriversGuess) {
  std::unique_ptr<Card> card;
  try {
    card = std::make_unique<Card>(openContextHere);
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << "no OpenGL 4.3 here: " << error.what();
  }
  const std::vector<TypeParam> a = numbers<TypeParam>(1), b = numbers<TypeParam>(2);
  constexpr int kMost = Exact<TypeParam>::kMostUnits;
  for (const int units : {0, 1, -2, kMost, -kMost}) {
    const OnCardResults<TypeParam> there = computed(*card, a, b, units);
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < kNumbers; ++k) {
      wrong += there.roots[k] != std::sqrt(a[k]);
      wrong += there.quotients[k] != a[k] / b[k];
    }
    EXPECT_EQ(wrong, 0U) << units << " units off";
  }
}

}  // namespace
}  // namespace tyg
