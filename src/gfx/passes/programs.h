// The shader programs of one OpenGL context, shared by all renderers in it: a driver takes up to a second for one.
// Must not know: what is drawn with them.
#pragma once

#include <list>
#include <string>
#include <string_view>

#include "gfx/gl_objects.h"

namespace tyg {

class Programs {
 public:
  /// Made when it is first asked for; see GlProgram. Allocates nothing for one that has been.
  [[nodiscard]] const GlProgram& get(std::string_view stem, std::string_view defines = {},
                                     const char* written = nullptr) {
    for (const Entry& entry : entries_) {
      if (entry.stem == stem && entry.defines == defines) return entry.program;
    }
    return entries_.emplace_back(stem, defines, written).program;
  }

 private:
  struct Entry {
    Entry(std::string_view of, std::string_view with, const char* written)
        : stem(of), defines(with), program(of, with, written) {}
    std::string stem, defines;
    GlProgram program;
  };
  std::list<Entry> entries_;  // whose places stay the same
};

}  // namespace tyg
