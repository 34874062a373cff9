// Runs the program in the background, so that a test can stop it at any moment.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/apps/temporary_directory.h"

namespace ease {

class Started {
 public:
  /// Starts `ease ARGUMENTS` in `directory`.  The new process calls `prepare` first.  Output goes to the files `out`
  /// and `err` in the directory.
  Started(const TemporaryDirectory& directory, std::vector<std::string> arguments,
          const std::function<void()>& prepare = nullptr) {
    arguments.insert(arguments.begin(), "ease");
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    sigset_t all, before;  // no signal may reach the child while it has this process' handlers
    ::sigfillset(&all);
    ::sigprocmask(SIG_BLOCK, &all, &before);
    process_ = ::fork();
    if (process_ == 0)
      for (const int signal : {SIGINT, SIGTERM}) ::signal(signal, SIG_DFL);
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    REQUIRE(process_ >= 0);
    if (process_ > 0) return;
    if (::chdir(directory.path.c_str()) != 0) ::_exit(99);
    ::dup2(::open("out", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    ::dup2(::open("err", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (prepare) prepare();
    ::execv(EASE_COMMAND, pointers.data());
    ::_exit(99);
  }
  ~Started() {
    if (!ended_) stop(SIGKILL);
  }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;

  /// Waits until `condition()` is true or the program has ended.
  template <class Condition>
  void waitUntil(const Condition& condition) {
    while (!ended_ && !condition()) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      ended_ = ::waitpid(process_, &status_, WNOHANG) == process_;
    }
  }

  /// Sends the signal, unless the program has already ended, and waits for its end.
  void stop(int signal) {
    if (!ended_) ::kill(process_, signal);
    wait();
  }

  void wait() {
    while (!ended_) ended_ = ::waitpid(process_, &status_, 0) == process_ || errno != EINTR;
  }

  int code() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }
  int signal() const { return WIFSIGNALED(status_) ? WTERMSIG(status_) : 0; }

 private:
  pid_t process_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace ease
