// Rows come back in order and are added up as Forces adds them.
#include "gpu/card_measure.h"

#include <fmt/core.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace tyg {
namespace {

constexpr unsigned kResults = 3;  // the binding of what kernels/measure.glsl and kernels/largest.glsl find
constexpr int kRowsOfGroup = 16;  // as kernels/measure.glsl has it
constexpr std::size_t kEnergies = 5, kPowers = 3;  // numbers of a row, in the order of the kernel

static_assert(kSupplies[0] == AirTerm::kSupply && kSupplies[1] == ContactTerm::kSupply,
              "kernels/measure.glsl tells what wind and bodies bring, in this order, and nothing else");

std::array<double, 3> lawOf(const SpringLaw<double>& law) { return {law.ks, law.rest, law.kd}; }

}  // namespace

CardMeasure::CardMeasure(Card& card, const CardSheet& sheet)
    : card_(card), sheet_(sheet), moments_(card), rows_(card), largest_(card) {}

Kernel& CardMeasure::kernelOf(Measured what) {
  const KernelTerms& terms = sheet_.terms();
  Kernel& kernel = card_.kernel(
      "measure.glsl", fmt::format("#define ENERGY {:d}\n#define AIR {:d}\n#define CONTACT {:d}\n"
                                  "#define CUT {:d}\n#define AXIAL {:d}\n",
                                  what == Measured::Energy, terms.air, terms.contact, terms.cut, terms.damping == 2));
  kernel.use();
  return kernel;
}

void CardMeasure::run(Kernel& kernel, std::size_t moment) {
  moments_.tell(kernel, moment);
  const AllTerms::Numbers<double>& numbers = moments_.moments().numbers;
  kernel.set("structural", lawOf(static_cast<const StructuralSprings::Numbers<double>&>(numbers).law));
  kernel.set("shear", lawOf(static_cast<const ShearSprings::Numbers<double>&>(numbers).law));
  kernel.set("bend", lawOf(static_cast<const BendSprings::Numbers<double>&>(numbers).law));
  rows_.show(kResults);
  sheet_.dispatch(kernel, 1, (sheet_.sheet().rows + kRowsOfGroup - 1) / kRowsOfGroup);
}

StoredEnergy CardMeasure::energy() {
  const auto rows = static_cast<std::size_t>(sheet_.sheet().rows);
  std::vector<double> found(kEnergies * rows);
  rows_.reserve(found.size() * sizeof(double));
  const AllTerms::Numbers<double>& numbers = moments_.moments().numbers;
  Kernel& kernel = kernelOf(Measured::Energy);
  kernel.set("firstRow", 0);
  kernel.set("mass", sheet_.sheet().particleMass);
  kernel.set("weight", std::to_array(numbers.weight));
  const ContactTerm::Numbers<double>& contact = numbers;
  kernel.set("contactScale", contact.force * contact.layer);
  run(kernel, 0);
  rows_.read(found.data(), found.size() * sizeof(double));
  StoredEnergy sum;
  for (const double* row = found.data(); row != found.data() + found.size(); row += kEnergies) {
    StoredEnergy one;
    one.kinetic = row[0];
    one.of<StructuralSprings>() = row[1];  // all springs share this sum
    one.of<Gravity>() = row[2], one.of<ContactTerm>() = row[3];
    one.maxStretch = row[4];
    sum.add(one);
  }
  return sum;
}

void CardMeasure::beginPower(std::size_t moment) {
  const auto rows = static_cast<std::size_t>(sheet_.sheet().rows);
  rows_.reserve(kPowers * rows * moments_.moments().moments.size() * sizeof(double));
  Kernel& kernel = kernelOf(Measured::Power);
  kernel.set("firstRow", int(moment * rows));
  kernel.set("drag", moments_.moments().numbers.drag);
  run(kernel, moment);
}

std::vector<Power> CardMeasure::powers() {
  const auto rows = static_cast<std::size_t>(sheet_.sheet().rows);
  std::vector<Power> powers(moments_.moments().moments.size());
  std::vector<double> found(kPowers * rows * powers.size());
  rows_.read(found.data(), found.size() * sizeof(double));
  const double* row = found.data();
  for (Power& power : powers) {
    for (std::size_t k = 0; k < rows; ++k, row += kPowers) {
      power.add({.lost = row[0], .supplied = {row[1], row[2]}});
    }
  }
  return powers;
}

DeviceState<float>::Largest CardMeasure::largest() {
  std::array<std::uint32_t, 2> found{};
  largest_.write(found.data(), sizeof found);
  Kernel& kernel = card_.kernel("largest.glsl", fmt::format("#define CUT {:d}\n", sheet_.terms().cut));
  kernel.use();
  largest_.show(kResults);
  sheet_.dispatch(kernel);
  largest_.read(found.data(), sizeof found);
  return {std::bit_cast<float>(found[0]), std::bit_cast<float>(found[1])};
}

}  // namespace tyg
