// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <optional>
#include <type_traits>

/// The outcome of a function that ran in a process of its own.
template <class Value>
struct ChildResult {
  std::optional<Value> value;  ///< empty if it failed, or was stopped
  bool isOver = false;         ///< whether it was stopped at the limit
  double megabytes = 0;        ///< its peak memory
};

/// Runs `run` in a child process, at most up to the limit. Value has no pointers.
template <class Value, class Run>
ChildResult<Value> runInChild(unsigned limitSeconds, Run run) {
  static_assert(std::is_trivially_copyable_v<Value>);
  std::fflush(stdout);  // a child must not print the text that is waiting here
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    alarm(limitSeconds);
    const Value value = run();
    const bool written = write(ends[1], &value, sizeof value) == sizeof value;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  Value value{};
  const bool isRead = read(ends[0], &value, sizeof value) == sizeof value;
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  ChildResult<Value> result;
  result.isOver = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  if (isRead && WIFEXITED(status) && WEXITSTATUS(status) == 0) result.value = value;
  result.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  return result;
}
