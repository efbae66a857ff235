// What is printed is made harmless, also where a character comes in parts.
#include "app/output/standard_streams.h"

#include <gtest/gtest.h>

#include <sstream>

namespace tyg {
namespace {

TEST(HarmlessOutput, ReplacesWhatIsActiveAndKeepsCharactersThatComeInParts) {
  std::ostringstream out;
  {
    HarmlessOutput harmless(out);
    out << "a\n\x1B[31m\xC3" << '\xA9' << "\xE7\xB5"
        << "\xB9\xC2"
        << "\x9B" << std::flush << "\xF0\x9F";
  }
  EXPECT_EQ(out.str(), "a\n\xEF\xBF\xBD[31m\xC3\xA9\xE7\xB5\xB9\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(HarmlessOutput, TellsThatTheStreamBelowFails) {
  class Full : public std::streambuf {};  // takes nothing
  Full full;
  std::ostream out(&full);
  HarmlessOutput harmless(out);
  out << "text" << std::flush;
  EXPECT_FALSE(out);
}

}  // namespace
}  // namespace tyg
