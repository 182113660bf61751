// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How long does a planner take on a machine that it has to share? Linked into a program, this makes
// every clock of it, the standard library's and OMPL's among them, count the processor time that
// the program has used, that of all its threads together: what others do beside it does not count,
// and two threads take twice the time of one. Linux only.
#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>

extern "C" int clock_gettime(clockid_t, timespec* time) noexcept {
  return static_cast<int>(syscall(SYS_clock_gettime, CLOCK_PROCESS_CPUTIME_ID, time));
}
