// How deep the keys of a TOML text go, told before it is parsed: every part of a key such as a.b.c is a table in a
// table for the parser, which calls itself for each of them. Must not know: which keys a scene has.
#pragma once

#include <string_view>

namespace tyg {

/// The line, counted from 1, of the first key or table name of more than `most` parts with points between; 0 where
/// there is none. Points in texts, comments and numbers do not count. Of a text that is not TOML any answer may come.
int lineOfDeepKey(std::string_view text, int most);

}  // namespace tyg
