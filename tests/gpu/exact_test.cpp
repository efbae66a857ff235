// Square roots and quotients on the card are the processor's, to the last bit, also where a driver's own are a few
// units off.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "card_here.h"
#include "gpu/card.h"
#include "gpu/card_buffer.h"

namespace tyg {
namespace {

constexpr const char* kMain = R"(
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer A { float a[]; };
layout(std430, binding = 1) readonly buffer B { float b[]; };
layout(std430, binding = 2) writeonly buffer Roots { float roots[]; };
layout(std430, binding = 3) writeonly buffer Quotients { float quotients[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  roots[i] = exactRoot(a[i]);
  quotients[i] = exactQuotient(a[i], b[i]);
}
)";

/// The whole text, with guesses that are off by some units in their last place.
std::string textWithGuessesOffBy(int units) {
  std::string exact = textOf("exact.glsl");
  const auto spoil = [&](std::string_view guess) {
    const std::size_t at = exact.find(guess);
    EXPECT_NE(at, std::string::npos) << guess;
    exact.replace(at, guess.size(), "uintBitsToFloat(floatBitsToUint(" + std::string(guess) + ") + uint(OFF))");
  };
  spoil("sqrt(withoutExponent(fraction) * float(1 + odd))");
  spoil("withoutExponent(numerator) / withoutExponent(denominator)");
  return "#version 430 core\n#define OFF " + std::to_string(units) + "\n" + exact + kMain;
}

constexpr std::size_t kNumbers = 1 << 18;

/// Numbers of all sizes that a quotient of two leaves within the ordinary ones, and some beside powers of two.
std::vector<float> numbers(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<float> all;
  for (std::size_t k = 0; k < kNumbers; ++k) {
    const std::uint32_t exponent = 70 + random() % 110;
    const std::uint32_t anywhere = random() & 0x7fffff, beside = (random() % 8 - 4) & 0x7fffff;
    all.push_back(std::bit_cast<float>(exponent << 23 | (k % 4 == 0 ? beside : anywhere)));
  }
  return all;
}

struct OnCardResults {
  std::vector<float> roots = std::vector<float>(kNumbers), quotients = std::vector<float>(kNumbers);
};

OnCardResults computed(Card& card, const std::vector<float>& a, const std::vector<float>& b, int units) {
  OnCardResults results;
  card.run([&] {
    Kernel kernel(card.gl(), "exactness", textWithGuessesOffBy(units));
    CardBuffer inA(card), inB(card), outRoots(card), outQuotients(card);
    const std::size_t bytes = kNumbers * sizeof(float);
    inA.write(a.data(), bytes), inB.write(b.data(), bytes), outRoots.reserve(bytes), outQuotients.reserve(bytes);
    inA.show(0), inB.show(1), outRoots.show(2), outQuotients.show(3);
    kernel.use();
    card.gl().DispatchCompute(kNumbers / 64, 1, 1);
    outRoots.read(results.roots.data(), bytes), outQuotients.read(results.quotients.data(), bytes);
    card.refuseErrors();
  });
  return results;
}

TEST(Exactness, HoldsForEveryNumberWhateverTheDriversGuess) {
  std::unique_ptr<Card> card;
  try {
    card = std::make_unique<Card>(openContextHere);
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << "no OpenGL 4.3 here: " << error.what();
  }
  const std::vector<float> a = numbers(1), b = numbers(2);
  for (const int units : {0, 3, -3, 7, -7}) {
    const OnCardResults there = computed(*card, a, b, units);
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
