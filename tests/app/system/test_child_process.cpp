// Work in a child process: its result, its output and the report of its end.
#include "app/system/child_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <new>

#include "base/error.h"
#include "tests/support/support.h"

using namespace fascia;
using fascia::test::contains;

TEST_CASE("a crash, hang or failure in a child is reported") {
  CHECK(run_in_child([] { return std::string("done"); }, 60).answer == "done");
  CHECK(run_in_child([]() -> std::string { throw Error("a", "b", "c"); }, 60).failure == "a: b; c");
  const ChildReport crashed = run_in_child(
      []() -> std::string {
        std::raise(SIGKILL);
        return "";
      },
      60);
  CHECK(contains(crashed.failure, "crashed (Killed)"));
  CHECK(contains(run_in_child(
                     []() -> std::string {
                       for (;;) pause();
                     },
                     0.3)
                     .failure,
                 "took longer than 0.3 s"));
  CHECK(run_in_child(
            [] {
              std::puts("said");
              std::fflush(stdout);
              return std::string();
            },
            60)
            .said == "said\n");
  const std::string large(1 << 20, 'x');  // more than a pipe holds
  CHECK(run_in_child([&] { return large; }, 60).answer == large);
}

TEST_CASE("changes by a child stay in the child, and a lack of memory has its own line") {
  int number = 1;
  const ChildReport report = run_in_child(
      [&] {
        number = 2;
        return std::to_string(number);
      },
      60);
  CHECK(report.answer == "2");
  CHECK(report.failure.empty());
  CHECK(number == 1);
  CHECK(contains(run_in_child([]() -> std::string { throw std::bad_alloc(); }, 60).failure, "needs more memory"));
}

TEST_CASE("children work at the same time, and an abandoned child is ended") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  // The first child waits for output of the second one.
  ChildProcess first(
      [&] {
        char c = 0;
        return read(ends[0], &c, 1) == 1 ? std::string(1, c) : std::string("none");
      },
      60);
  CHECK_FALSE(first.ended(0));
  ChildProcess second([&] { return write(ends[1], "x", 1) == 1 ? std::string("written") : std::string("failed"); }, 60);
  while (!second.ended(100) || !first.ended(100)) continue;
  CHECK(second.report().answer == "written");
  CHECK(first.report().answer == "x");
  close(ends[0]);
  close(ends[1]);
  {
    ChildProcess left(
        []() -> std::string {
          for (;;) pause();
        },
        600);
  }
  CHECK(waitpid(-1, nullptr, WNOHANG) == -1);  // no child is left
}
