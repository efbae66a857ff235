// Event logs with mistakes in them, and what the refusals say.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tyg/event_log.h"

namespace tyg::test {

inline const std::string kNothingRefused = "nothing was refused";

inline std::string refusalOf(const std::string& text) {
  try {
    (void)parseEventLog(text, "my.log");
  } catch (const InputError& mistake) {
    return mistake.what();
  }
  return kNothingRefused;
}

/// A line (from 1) of a right log is changed to this text, or added after its last one; the refusal begins with this.
struct LogMistake {
  std::size_t line;
  std::string text, refusal;
};

inline void expectRefusals(const std::string& right, const std::vector<LogMistake>& mistakes) {
  for (const LogMistake& mistake : mistakes) {
    std::string text;
    std::size_t number = 0;
    for (std::size_t from = 0; from < right.size(); from = right.find('\n', from) + 1) {
      const std::string line = right.substr(from, right.find('\n', from) - from);
      text += (++number == mistake.line ? mistake.text : line) + '\n';
    }
    if (number < mistake.line) text += mistake.text + '\n';
    const std::string refusal = refusalOf(text);
    EXPECT_EQ(refusal.find(mistake.refusal), 0U) << mistake.text << "\n  " << refusal;
  }
}

}  // namespace tyg::test
