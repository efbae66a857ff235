// What the window remembers from one time to the next, as names and words, in a small file that is written whole.
// Must not know: what is remembered, windows.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace tyg {

/// XDG_CONFIG_HOME/tyg/window, else HOME/.config/tyg/window; nothing where neither is set.
std::optional<std::filesystem::path> windowMemoryFile();

class WindowMemory {
 public:
  /// Nothing: nothing is remembered. A file that is not like those that this writes is ignored, and trouble() says so.
  explicit WindowMemory(std::optional<std::filesystem::path> file);

  /// Nothing where there is none of this name.
  [[nodiscard]] std::optional<std::string> find(std::string_view name) const;
  /// Writes the file where the word is another one than before. A file that cannot be written is left as it is.
  void keep(std::string_view name, const std::string& word);
  /// What find() told for this name was of no use: it is forgotten, and trouble() says so.
  void refuse(std::string_view name);
  /// A sentence for the person; empty: there was none.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  /// False where it is not as keep() writes it.
  bool read(std::string_view text);
  void complain();

  std::optional<std::filesystem::path> file_;
  std::map<std::string, std::string, std::less<>> words_;
  std::string trouble_;
};

}  // namespace tyg
