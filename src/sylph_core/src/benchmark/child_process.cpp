#include "benchmark/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <future>
#include <string_view>

#include "files/text_file.hpp"

namespace sylph {
namespace {

constexpr double kLongestLimit_s = 1e8;  // what clocks can count
constexpr int kCannotRun = 127;          // exit status, as shells have it

/// What the child does between fork() and the program: only what is safe in a process that has one
/// of several threads (signal-safety(7)).
[[noreturn]] void becomeProgram(char* const* words, const char* folder, int log) {
  // Ctrl-C in a terminal ends the caller's group, not this one.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  const int input = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(input, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  if (chdir(folder) == 0) {
    execv(words[0], words);
  }
  constexpr std::string_view kMessage = "the program cannot be executed\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kMessage.data(), kMessage.size());
  _exit(kCannotRun);
}

/// @return the process group, which is the child's process id
pid_t start(const std::vector<std::string>& words, const std::string& folder,
            const std::string& log_path) {
  std::vector<std::string> copies = words;  // execv() does not take constants
  std::vector<char*> arguments;
  for (std::string& word : copies) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  const int log = open(log_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (log < 0) {
    throw fileError(log_path, 0, std::string("cannot be written: ") + std::strerror(errno));
  }
  const pid_t child = fork();
  if (child == 0) {
    becomeProgram(arguments.data(), folder.c_str(), log);
  }
  const int error = errno;
  close(log);
  if (child < 0) {
    throw fileError(words.front(), 0, std::string("cannot be started: ") + std::strerror(error));
  }
  setpgid(child, child);  // whoever comes first, so that the group is there from here on
  return child;
}

}  // namespace

ProgramEnd runProgram(const std::vector<std::string>& words, const std::string& folder,
                      const std::string& log_path, double limit_s) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const pid_t child = start(words, folder, log_path);
  // Does not reap it: until then its id, and that of its group, is nobody else's.
  const auto waitForEnd = [child] {
    siginfo_t info{};
    while (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT) != 0 &&
           errno == EINTR) {
    }
  };
  ProgramEnd end;
  {
    const auto ended = std::async(std::launch::async, waitForEnd);
    const std::chrono::duration<double> limit(std::min(limit_s, kLongestLimit_s));
    end.was_killed = ended.wait_for(limit) != std::future_status::ready;
    end.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    kill(-child, SIGKILL);  // what it has started and left behind, too
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!end.was_killed) {
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  }
  return end;
}

}  // namespace sylph
