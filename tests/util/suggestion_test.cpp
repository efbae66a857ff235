// Words that somebody nearly typed.
#include "util/suggestion.h"

#include <gtest/gtest.h>

#include <array>

namespace tyg {
namespace {

TEST(EditDistance, CountsChangesAdditionsOmissionsAndExchanges) {
  EXPECT_EQ(editDistance("flag", "flag"), 0U);
  EXPECT_EQ(editDistance("flag", "flog"), 1U);
  EXPECT_EQ(editDistance("flag", "flags"), 1U);
  EXPECT_EQ(editDistance("flag", "lag"), 1U);
  EXPECT_EQ(editDistance("flag", "falg"), 1U);
  EXPECT_EQ(editDistance("", "flag"), 4U);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
}

TEST(DidYouMean, NamesTheNearestWordAndNothingThatIsFar) {
  constexpr std::array<std::string_view, 4> kWords{"curtain", "flag", "rk4", "leapfrog"};
  EXPECT_EQ(didYouMean("courtain", kWords), "; did you mean 'curtain'?");
  EXPECT_EQ(didYouMean("leap-frog", kWords), "; did you mean 'leapfrog'?");
  EXPECT_EQ(didYouMean("rk5", kWords), "; did you mean 'rk4'?");
  EXPECT_EQ(didYouMean("hammock", kWords), "");
  EXPECT_EQ(didYouMean("", kWords), "");
  EXPECT_EQ(didYouMean("x", kWords), "");
}

}  // namespace
}  // namespace tyg
