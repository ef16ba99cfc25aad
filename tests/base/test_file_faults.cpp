// Writers of the same file, in threads and in ended processes.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using fascia::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

/// The id of a process that has ended.
pid_t gone_process() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return child;
}

void touch(const fs::path& path) { std::ofstream(path) << "half"; }

}  // namespace

TEST_CASE("threads that write the same file leave one of their texts", "[file]") {
  const TemporaryFolder folder;
  constexpr int writers = 4, times = 25;
  std::vector<std::string> texts;
  for (int w = 0; w < writers; ++w) texts.emplace_back(200000, static_cast<char>('a' + w));
  int failed = 0, half = 0;
  for (int i = 0; i < times; ++i) {
    std::vector<std::thread> threads;
    std::vector<int> failures(writers, 0);
    for (int w = 0; w < writers; ++w) {
      threads.emplace_back([&, w] {
        try {
          write_file(folder / "out", texts[static_cast<std::size_t>(w)]);
        } catch (const Error&) {
          failures[static_cast<std::size_t>(w)] = 1;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (const int failure : failures) failed += failure;
    half += std::find(texts.begin(), texts.end(), read_file(folder / "out")) == texts.end();
  }
  std::printf("%d threads, %d times: %d writes failed, %d half files\n", writers, times, failed, half);
  CHECK(failed == 0);
  CHECK(half == 0);
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("temporary files of killed processes are removed when the file is written again", "[file]") {
  const TemporaryFolder folder;
  const std::string gone = std::to_string(gone_process()), alive = std::to_string(getppid());
  const std::vector<std::string> stale = {".out." + gone + "-1.part.vtu", ".out." + gone + "-12.part.mp4.log"};
  const std::vector<std::string> kept = {".out." + alive + "-1.part.vtu", ".other." + gone + "-1.part.vtu",
                                         ".out." + gone + ".vtu", ".out.part.vtu", ".out.5x-1.part.vtu"};
  for (const auto& names : {stale, kept})
    for (const std::string& name : names) touch(folder / name);

  CHECK_THROWS(write_file(folder / "out.vtu", [](std::ostream&) { throw Error("fails"); }));
  for (const std::string& name : stale) CHECK(fs::exists(folder / name));  // a failed write removes nothing
  write_file(folder / "out.vtu", "new");
  for (const std::string& name : stale) {
    CAPTURE(name);
    CHECK(!fs::exists(folder / name));
  }
  for (const std::string& name : kept) {
    CAPTURE(name);
    CHECK(fs::exists(folder / name));
  }
  CHECK(read_file(folder / "out.vtu") == "new");
}
