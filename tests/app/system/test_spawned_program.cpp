// A program that runs beside this one.
#include <catch2/catch.hpp>

#include "app/system/spawned_program.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr double kLong = 60;  // [s]

}  // namespace

TEST_CASE("a spawned program gets its input and environment, and its end is seen") {
  const TemporaryFolder folder;
  const std::string file = (folder / "said").string();
  SpawnedProgram program({"sh", "-c", "read word; echo \"$word $GREETED\" > \"$0\"", file}, {{"GREETED", "world"}});
  CHECK_FALSE(program.ended());
  program.write("hello\n");
  const auto end = program.wait_for_end(kLong);
  REQUIRE(end);
  CHECK(end->succeeded);
  CHECK(read_file(file) == "hello world\n");
  program.write("to nobody\n");  // has no effect
}

TEST_CASE("what a spawned program says is in its file") {
  const TemporaryFolder folder;
  SpawnedProgram program({"sh", "-c", "echo out; echo err >&2; echo end"}, {}, folder / "said");
  REQUIRE(program.wait_for_end(kLong));
  CHECK(read_file(folder / "said") == "out\nerr\nend\n");
}

TEST_CASE("what a spawned program answers to its input comes line by line") {
  SpawnedProgram program({"sh", "-c", "read word; echo \"$word 1\" >&0; echo 2 >&0; printf end >&0"});
  CHECK(program.answered_line(0.05) == "");
  program.write("line\n");
  CHECK(program.answered_line(kLong) == "line 1");
  CHECK(program.answered_line(kLong) == "2");
  CHECK(program.answered_line(kLong) == "end");
  REQUIRE(program.wait_for_end(kLong));
  CHECK(program.answered_line(kLong) == "");  // at once
}

TEST_CASE("a spawned program that fails, is asked to end, or is missing") {
  SpawnedProgram failing({"sh", "-c", "exit 3"});
  REQUIRE(failing.wait_for_end(kLong));
  CHECK_FALSE(failing.ended()->succeeded);
  SpawnedProgram asked({"sleep", "1000"});
  CHECK_FALSE(asked.wait_for_end(0.05));
  asked.ask_to_end();
  REQUIRE(asked.wait_for_end(kLong));
  CHECK_FALSE(asked.ended()->succeeded);
  CHECK_THROWS_WITH(SpawnedProgram({"no-such-program-of-fascia"}), Catch::Contains("cannot be run"));
}

TEST_CASE("a spawned program ends with its object, and its time of computing is measured") {
  const TemporaryFolder folder;
  const std::string file = (folder / "alive").string();
  { const SpawnedProgram program({"sh", "-c", "sleep 1000; echo > \"$0\"", file}); }
  CHECK_FALSE(std::filesystem::exists(file));
  SpawnedProgram computing({"sh", "-c", "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done"});
  const auto end = computing.wait_for_end(kLong);
  REQUIRE(end);
  CHECK(end->cpu_seconds > 0);
}
