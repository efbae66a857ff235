// Numbers are copied one after the other, so that a kernel finds them whatever the processor's structures look like.
#include "gpu/card_moments.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tyg {
namespace {

constexpr unsigned kGusts = 11, kSolids = 12;  // bindings
/// How many numbers of a gust and of a body kernels/air.glsl and kernels/contact.glsl expect.
constexpr std::size_t kGustSize = 7, kSolidSize = 12;

template <class T, std::size_t count>
void add(const T (&from)[count], std::vector<T>& to) {
  to.insert(to.end(), std::begin(from), std::end(from));
}

template <class T>
void write(const std::vector<T>& numbers, CardBuffer& buffer) {
  if (!numbers.empty()) buffer.write(numbers.data(), numbers.size() * sizeof(T));
}

}  // namespace

template <class T>
void CardMoments<T>::add(const AllTerms::Numbers<T>& now) {
  numbers = now;
  AirTerm::Numbers<T>& itsAir = numbers;
  ContactTerm::Numbers<T>& itsContact = numbers;
  itsAir.firstGusts = itsAir.endGusts = nullptr;  // these are of the moment, and do not last
  itsContact.firstSolid = itsContact.endSolid = nullptr;
  Moment& moment = moments.emplace_back();
  const AirTerm::Numbers<T>& air = now;
  std::ranges::copy(air.steady, moment.steadyWind.begin());
  moment.firstGust = int(gusts.size() / kGustSize);
  for (const AirTerm::Gusts<T>* gust = air.firstGusts; gust != air.endGusts; ++gust) {
    tyg::add(gust->amplitude, gusts), tyg::add(gust->wave, gusts);
    gusts.push_back(gust->phase);
  }
  moment.endGust = int(gusts.size() / kGustSize);
  const ContactTerm::Numbers<T>& contact = now;
  moment.firstSolid = int(solids.size() / kSolidSize);
  for (const ContactTerm::Solid<T>* solid = contact.firstSolid; solid != contact.endSolid; ++solid) {
    solids.push_back(T(int(solid->shape)));
    tyg::add(solid->at, solids), tyg::add(solid->axis, solids);
    solids.push_back(solid->perSquare), solids.push_back(solid->radius);
    tyg::add(solid->velocity, solids);
  }
  moment.endSolid = int(solids.size() / kSolidSize);
}

template <class T>
MomentsOnCard<T>::MomentsOnCard(Card& card) : gusts_(card), solids_(card) {
  // A kernel may look at a block of memory that it does not use: none of them may be missing.
  gusts_.reserve(sizeof(T)), solids_.reserve(sizeof(T));
}

template <class T>
void MomentsOnCard<T>::write(CardMoments<T> moments) {
  moments_ = std::move(moments);
  tyg::write(moments_.gusts, gusts_);
  tyg::write(moments_.solids, solids_);
}

template <class T>
void MomentsOnCard<T>::tell(Kernel& kernel, std::size_t moment) const {
  gusts_.show(kGusts), solids_.show(kSolids);
  const auto& now = moments_.moments.at(moment);
  kernel.set("steadyWind", now.steadyWind);
  kernel.set("firstGust", now.firstGust), kernel.set("endGust", now.endGust);
  kernel.set("firstSolid", now.firstSolid), kernel.set("endSolid", now.endSolid);
  const AirTerm::Numbers<T>& air = moments_.numbers;
  kernel.set("airFactor", air.factor), kernel.set("tinyArea", air.tinyArea);
  const ContactTerm::Numbers<T>& contact = moments_.numbers;
  kernel.set("contactForce", contact.force), kernel.set("perLayer", contact.perLayer);
  kernel.set("contactDamping", contact.damping), kernel.set("friction", contact.friction);
  kernel.set("slip", contact.slip);
}

template struct CardMoments<float>;
template struct CardMoments<double>;
template class MomentsOnCard<float>;
template class MomentsOnCard<double>;

}  // namespace tyg
