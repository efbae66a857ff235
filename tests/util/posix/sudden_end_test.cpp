// Every end of a process but SIGKILL leaves neither unfinished files nor programs that it has started.
#include "util/sudden_end.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>

#include "files.h"
#include "util/child_process.h"
#include "util/interrupt.h"
#include "util/sudden_end_system.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

/// How a process of its own ended that did this and then exited with 0.
template <class Work>
int statusOf(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST(SuddenEnd, NoSignalLeavesAnUnfinishedFile) {
  const Folder folder;
  for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGQUIT, SIGPIPE, SIGXCPU, SIGUSR1, SIGABRT, SIGILL}) {
    const int status = statusOf([&] {
      WholeFile file(folder / "a.csv");
      file.write("half");
      (void)std::raise(signal);
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    EXPECT_EQ(folder.fileCount(), 0U) << signal;
  }
}

/// What a debugger sees of the last signal that a process gets which does this; nothing where none is allowed.
template <class Work>
siginfo_t lastSignalOf(const Work& work, int& status) {
  const pid_t child = fork();
  if (child == 0) {
    ptrace(PTRACE_TRACEME);
    work();
    _exit(0);
  }
  siginfo_t last{};
  while (waitpid(child, &status, 0) == child && WIFSTOPPED(status)) {
    ptrace(PTRACE_GETSIGINFO, child, nullptr, &last);
    ptrace(PTRACE_CONT, child, nullptr, WSTOPSIG(status));
  }
  return last;
}

TEST(SuddenEnd, AFaultLeavesNoUnfinishedFileAndEndsTheProcessWhereItHappened) {
  const Folder folder;
  void* const forbidden = mmap(nullptr, 1, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(forbidden, MAP_FAILED);
  int status = 0;
  const siginfo_t last = lastSignalOf(
      [&] {
        (void)std::signal(SIGSEGV, SIG_DFL);  // sanitizers have a handler of their own
        catchSuddenEnds();
        WholeFile file(folder / "a.csv");
        file.write("half");
        *static_cast<volatile char*>(forbidden) = 1;
      },
      status);
  munmap(forbidden, 1);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGSEGV);
  EXPECT_TRUE(last.si_signo == 0 || last.si_addr == forbidden);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(SuddenEnd, NeitherDoExitNorAnExceptionThatNobodyCatches) {
  const Folder folder;
  (void)statusOf([&] {
    const WholeFile file(folder / "a.csv");
    std::exit(3);
  });
  EXPECT_EQ(folder.fileCount(), 0U);
  (void)statusOf([&] {
    const WholeFile file(folder / "a.csv");
    std::terminate();
  });
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(SuddenEnd, AFileBeyondTheLimitOfTheProcessIsNoSignal) {
  EXPECT_EQ(statusOf([&] {
              prepareForSuddenEnd();
              (void)std::raise(SIGXFSZ);
            }),
            0);
}

TEST(SuddenEnd, ProgramsThatWereStartedEndToo) {
  const Folder folder;
  const std::string file = (folder / "number").string();
  (void)statusOf([&] {
    const ChildProcess child({"sh", "-c", "echo $$ >'" + file + "'; exec sleep 100"});
    while (contentsOf(file).empty()) {
    }
    (void)std::raise(SIGTERM);
  });
  std::string state;
  do {  // until the signal has reached it
    state = contentsOf("/proc/" + std::to_string(std::stoi(contentsOf(file))) + "/stat");
  } while (!state.empty() && !holds(state, ") Z"));
}

TEST(SuddenEnd, WorkThatIsToBeDoneFirstIsDoneWhereALibraryCallsExit) {
  const Folder folder;
  const int status = statusOf([&] {
    const AtExit keepFirst([&] { writeWholeFile(folder / "record.csv", "kept"); });
    std::exit(0);
  });
  EXPECT_EQ(WEXITSTATUS(status), EXIT_FAILURE);
  EXPECT_EQ(contentsOf(folder / "record.csv"), "kept");
}

TEST(SuddenEnd, TheFirstInterruptIsAFlagTheSecondAnEndAndATerminalMayCloseTwice) {
  EXPECT_EQ(statusOf([] {
              const InterruptWatch watch;
              for (const int signal : {SIGHUP, SIGHUP, SIGINT}) (void)std::raise(signal);
              if (!interrupted()) _exit(1);
            }),
            0);
  const int status = statusOf([] {
    const InterruptWatch watch;
    for (const int signal : {SIGINT, SIGTERM}) (void)std::raise(signal);
  });
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
}

TEST(SuddenEnd, IgnoredSignalsStayIgnored) {
  EXPECT_EQ(statusOf([] {
              (void)std::signal(SIGHUP, SIG_IGN);
              (void)std::signal(SIGINT, SIG_IGN);
              const InterruptWatch watch;
              (void)std::raise(SIGHUP);
              (void)std::raise(SIGINT);
              if (interrupted()) _exit(1);
            }),
            0);
}

}  // namespace
}  // namespace tyg
