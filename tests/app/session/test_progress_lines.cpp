// Progress on stderr: silent for short work, then a line for each tenth of the steps.
#include <catch2/catch.hpp>
#include <chrono>
#include <iostream>
#include <sstream>
#include <thread>

#include "app/session/progress_lines.h"

using namespace fascia;

TEST_CASE("progress: short work is silent, longer work prints its tenths", "[progress]") {
  std::ostringstream said;
  std::streambuf* const stderr_buffer = std::cerr.rdbuf(said.rdbuf());
  const Progress opening = opening_progress("folder/big.msh"), stepping = stepping_progress("folder/liver.json");
  for (int step = 1; step <= 30; ++step) stepping(step / 100.0, "Simulating");
  opening(0.3, "Reading");
  const std::string early = said.str();
  std::this_thread::sleep_for(std::chrono::milliseconds(3100));  // they speak after three seconds
  opening(0.5, "Reading");
  for (int step = 31; step <= 100; ++step) stepping(step / 100.0, "Simulating");
  std::cerr.rdbuf(stderr_buffer);

  CHECK(early.empty());
  INFO(said.str());
  std::istringstream lines(said.str());
  std::string line;
  REQUIRE(std::getline(lines, line));
  CHECK(line.starts_with("fascia: big.msh: Reading, 50 %, about "));
  int tenths = 0;
  for (; std::getline(lines, line); ++tenths) {
    const std::string begin = "fascia: liver.json: Simulating, " + std::to_string(10 * (tenths + 4)) + " %, about ";
    CHECK(line.starts_with(begin));
    CHECK(line.ends_with(" s left"));
  }
  CHECK(tenths == 6);  // 40 to 90 %: the end is the result itself
}
