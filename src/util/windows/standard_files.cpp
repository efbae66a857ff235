// Windows would make two bytes of each end of line, take what is printed for text of the person's language, and lose
// letters of the command line that this language lacks.
#include "util/standard_files.h"

#include <windows.h>
// windows.h first: the header of the shell needs it.
#include <fcntl.h>
#include <io.h>
#include <shellapi.h>

#include "util/windows/wide.h"

namespace tyg {

void prepareStandardFiles() {
  for (const int file : {0, 1, 2}) {
    // _open() takes the lowest free number, which is this one.
    if (_setmode(file, _O_BINARY) < 0) (void)_open("NUL", _O_RDWR | _O_BINARY);
  }
  SetConsoleOutputCP(CP_UTF8);
  const HANDLE messages = GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  if (GetConsoleMode(messages, &mode) != 0) SetConsoleMode(messages, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

bool messagesGoToTerminal() {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

std::vector<std::string> programWords(int /*argc*/, char** /*argv*/) {
  int count = 0;
  wchar_t** const all = CommandLineToArgvW(GetCommandLineW(), &count);
  std::vector<std::string> words;
  for (int k = 1; k < count; ++k) words.push_back(narrow(all[k]));
  LocalFree(all);
  return words;
}

}  // namespace tyg
