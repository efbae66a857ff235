// The table of inputs: every action can be reached, no key means two things, and the help says all of it.
#include "viewer/input_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "viewer/tool.h"

namespace tyg {
namespace {

constexpr std::array<std::string_view, 3> kThreeMethods{"first", "second", "third"};

TEST(InputTable, NoKeyMeansTwoThings) {
  std::set<KeyCode> keys;
  for (const Input& input : inputTable()) EXPECT_TRUE(keys.insert(input.key).second) << input.keyName;
}

TEST(InputTable, EveryActionHasAnInput) {
  std::set<InputAction> actions;
  for (const Input& input : inputTable()) actions.insert(input.action);
  EXPECT_EQ(actions.size(), kInputActions);
}

TEST(InputTable, KeysOfTheContractDoWhatItSays) {
  EXPECT_EQ(findInput(' ')->action, InputAction::StartOrPause);
  EXPECT_EQ(findInput('.')->action, InputAction::Step);
  EXPECT_EQ(findInput(',')->action, InputAction::StepBack);
  EXPECT_EQ(findInput(']')->action, InputAction::LargerStep);
  EXPECT_EQ(findInput('R')->action, InputAction::Restart);
  EXPECT_EQ(findInput('F')->action, InputAction::FrameCloth);
  EXPECT_EQ(findInput('H')->action, InputAction::ShowHelp);
  EXPECT_EQ(findInput('Q')->action, InputAction::MoveDown);
  EXPECT_EQ(findInput('E')->action, InputAction::MoveUp);
  EXPECT_EQ(findInput(kEscapeKey)->action, InputAction::Leave);
}

TEST(InputTable, AnUnusedKeyDoesNothing) { EXPECT_EQ(findInput('`'), nullptr); }

TEST(InputTable, NumberKeysChooseMethodsInOrder) {
  EXPECT_EQ(methodSlot('1'), 0U);
  EXPECT_EQ(methodSlot('9'), 8U);
  EXPECT_EQ(methodSlot('0'), 9U);
  EXPECT_EQ(methodSlot('-'), 10U);
}

TEST(InputTable, HelpNamesEveryKeyButThoseOfferedElsewhereAndOfMissingMethods) {
  std::string help;
  for (const HelpLine& line : helpLines(kThreeMethods)) help += line.keys() + " ";
  for (const Input& input : inputTable()) {
    const bool missing = input.action == InputAction::ChooseMethod && methodSlot(input.key) >= kThreeMethods.size();
    const bool named = (" " + help).find(" " + std::string(input.keyName) + " ") != std::string::npos;
    EXPECT_EQ(named, !missing && !input.help.empty()) << input.keyName;
  }
}

TEST(InputTable, HelpShowsKeysThatBelongTogetherOnOneLine) {
  const auto lines = helpLines(kThreeMethods);
  EXPECT_EQ(std::ranges::count(lines, "W A S D", &HelpLine::keys), 1);
  EXPECT_EQ(std::ranges::count(lines, "Q E", &HelpLine::keys), 1);
  EXPECT_EQ(std::ranges::count(lines, "arrows", &HelpLine::keys), 1);
  EXPECT_EQ(std::ranges::count(lines, "F2 F3 F4", &HelpLine::keys), 1);
}

TEST(InputTable, TheShortListHasTenLinesAndTheKeyThatShowsAllKeysIsTheLastToGo) {
  const auto lines = helpLines(kThreeMethods);
  const auto all = firstLines(lines, 100);
  ASSERT_EQ(all.size(), 10U);
  for (std::size_t room = 1; room < all.size(); ++room) {
    const auto some = firstLines(lines, room);
    ASSERT_EQ(some.size(), room);
    EXPECT_EQ(some.back()->action(), InputAction::ShowAllKeys) << room;
    for (std::size_t k = 0; k + 1 < room; ++k) EXPECT_EQ(some[k], all[k]) << room;
  }
  EXPECT_TRUE(firstLines(lines, 0).empty());
}

TEST(InputTable, EveryToolHasTheFunctionKeyOfItsPlaceInItsTable) {
  EXPECT_EQ(findInput(functionKey(1))->action, InputAction::ShowAllKeys) << "F1 is help, as everywhere";
  EXPECT_EQ(findInput('?')->action, InputAction::ShowAllKeys);
  for (std::size_t slot = 0; slot < toolTable().size(); ++slot) {
    const KeyCode key = functionKey(static_cast<int>(slot) + 2);
    ASSERT_NE(findInput(key), nullptr);
    EXPECT_EQ(findInput(key)->action, InputAction::ChooseTool);
    EXPECT_EQ(findInput(key)->keyName, toolKeyName(slot));
    EXPECT_EQ(toolSlot(key), slot);
  }
}

TEST(InputTable, HelpNamesTheMethodsByTheirNumbers) {
  const auto lines = helpLines(kThreeMethods);
  const auto second = std::ranges::find(lines, "2", &HelpLine::keys);
  ASSERT_NE(second, lines.end());
  EXPECT_EQ(second->help, "second");
}

}  // namespace
}  // namespace tyg
