// Windows processes, one pipe for each direction. Windows itself ends a program, and all that it has started, with the
// last handle of the job that they are in, and so with this process however it ends.
#include "util/child_process.h"

#include <windows.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>

#include "util/windows/wide.h"

namespace tyg {
namespace {

using Clock = std::chrono::steady_clock;

Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

constexpr DWORD kNap = 5;                                    // ms between looks at the pipes
constexpr std::size_t kMostPrinted = std::size_t{4} << 20U;  // bytes

void mustBe(bool worked) {
  if (worked) return;
  const auto error = int(GetLastError());
  if (error == ERROR_FILE_NOT_FOUND) throw std::system_error(ENOENT, std::generic_category());
  throw std::system_error(error, std::system_category());
}

/// Something of the system's that is given back.
class Handle {
 public:
  Handle() = default;
  ~Handle() { close(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  void close() {
    if (handle_ != nullptr) CloseHandle(handle_);
    handle_ = nullptr;
  }
  [[nodiscard]] HANDLE get() const { return handle_; }
  HANDLE* out() { return &handle_; }

 private:
  HANDLE handle_ = nullptr;
};

/// A pipe whose one end a child gets.
void makePipe(Handle& read, Handle& write, const Handle& own) {
  constexpr DWORD kRoom = 1 << 16;  // bytes
  SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
  mustBe(CreatePipe(read.out(), write.out(), &inherited, kRoom) != 0);
  mustBe(SetHandleInformation(own.get(), HANDLE_FLAG_INHERIT, 0) != 0);
}

/// One word of a command line, so that the program gets it back as it is (Microsoft, "Parsing C command-line
/// arguments").
std::wstring quoted(const std::wstring& word) {
  if (!word.empty() && word.find_first_of(L" \t\"") == std::wstring::npos) return word;
  std::wstring text = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') text.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text.append(backslashes, L'\\') + L"\"";
}

std::wstring commandLine(const std::vector<std::string>& words) {
  std::wstring line;
  for (const std::string& word : words) line += (line.empty() ? L"" : L" ") + quoted(wide(word));
  return line;
}

}  // namespace

bool isOnPath(const std::string& program) {
  return SearchPathW(nullptr, wide(program).c_str(), L".exe", 0, nullptr, nullptr) > 0;
}

struct ChildProcess::Impl {
  std::function<bool()> stop;
  Handle job{}, process{}, input{}, output{};
  std::string printed{};
  bool ended = false;

  void start(const std::vector<std::string>& words, const std::filesystem::path& folder);
  void readAll();
  void end();
  DWORD status();
};

void ChildProcess::Impl::start(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  *job.out() = CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  mustBe(SetInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &limits, sizeof limits) != 0);
  Handle childsInput, childsOutput;
  makePipe(childsInput, input, input);
  makePipe(output, childsOutput, output);
  DWORD noWaiting = PIPE_NOWAIT;
  mustBe(SetNamedPipeHandleState(input.get(), &noWaiting, nullptr, nullptr) != 0);
  STARTUPINFOW startup{};
  startup.cb = sizeof startup;
  startup.dwFlags = STARTF_USESTDHANDLES;
  startup.hStdInput = childsInput.get();
  startup.hStdOutput = startup.hStdError = childsOutput.get();
  PROCESS_INFORMATION started{};
  std::wstring line = commandLine(words);
  constexpr DWORD kFlags = CREATE_SUSPENDED | CREATE_NO_WINDOW | CREATE_NEW_PROCESS_GROUP;
  mustBe(CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE, kFlags, nullptr,
                        folder.empty() ? nullptr : folder.c_str(), &startup, &started) != 0);
  *process.out() = started.hProcess;
  AssignProcessToJobObject(job.get(), started.hProcess);
  ResumeThread(started.hThread);
  CloseHandle(started.hThread);
}

/// Takes what is there to be read, without waiting.
void ChildProcess::Impl::readAll() {
  std::array<char, 4096> buffer{};
  DWORD count = 0;
  while (PeekNamedPipe(output.get(), nullptr, 0, nullptr, &count, nullptr) != 0 && count > 0) {
    if (ReadFile(output.get(), buffer.data(), DWORD(buffer.size()), &count, nullptr) == 0) return;
    if (printed.size() < kMostPrinted) printed.append(buffer.data(), count);
  }
}

void ChildProcess::Impl::end() {
  TerminateJobObject(job.get(), 1);
  WaitForSingleObject(process.get(), INFINITE);
  ended = true;
}

DWORD ChildProcess::Impl::status() {
  DWORD code = 0;
  GetExitCodeProcess(process.get(), &code);
  return code;
}

ChildProcess::ChildProcess(const std::vector<std::string>& words, const std::filesystem::path& folder,
                           std::function<bool()> stop)
    : impl_(new Impl{.stop = std::move(stop)}) {
  impl_->start(words, folder);
}

ChildProcess::~ChildProcess() {
  if (impl_ && !impl_->ended) impl_->end();
}

const std::string& ChildProcess::printed() const { return impl_->printed; }

bool ChildProcess::write(std::string_view bytes, double seconds) {
  Clock::time_point latest = after(seconds);
  while (!bytes.empty()) {
    impl_->readAll();
    if (impl_->stop() || Clock::now() > latest) return false;
    DWORD sent = 0;
    constexpr std::size_t kAtOnce = 4096;  // a pipe that does not wait takes all of it or nothing
    if (WriteFile(impl_->input.get(), bytes.data(), DWORD(std::min(bytes.size(), kAtOnce)), &sent, nullptr) == 0) {
      return false;
    }
    if (sent > 0) latest = after(seconds);
    if (sent == 0) Sleep(kNap);
    bytes.remove_prefix(sent);
  }
  return true;
}

ChildProcess::Ending ChildProcess::wait(double seconds) {
  const Clock::time_point latest = after(seconds);
  impl_->input.close();
  while (WaitForSingleObject(impl_->process.get(), kNap) == WAIT_TIMEOUT) {
    impl_->readAll();
    const bool isStopped = impl_->stop();
    if (!isStopped && Clock::now() <= latest) continue;
    impl_->end();
    return {isStopped ? Ending::Kind::Stopped : Ending::Kind::TooLate};
  }
  impl_->readAll();
  impl_->ended = true;
  return {Ending::Kind::ByItself, int(impl_->status())};
}

}  // namespace tyg
