#include "sim/fit/simulated/in_parallel.h"

#include <catch2/catch.hpp>
#include <set>
#include <stdexcept>

using namespace fascia;

TEST_CASE("jobs run in parallel, each once, and their exception arrives") {
  std::vector<std::atomic<int>> calls(100);
  in_parallel(calls.size(), [&](std::size_t i) { ++calls[i]; });
  for (const auto& count : calls) CHECK(count == 1);
  CHECK_THROWS_WITH(in_parallel(50,
                                [](std::size_t i) {
                                  if (i == 7) throw std::runtime_error("seven");
                                }),
                    "seven");
}

TEST_CASE("jobs run on so many threads at most") {
  std::set<std::thread::id> threads;
  in_parallel(
      20, [&](std::size_t) { threads.insert(std::this_thread::get_id()); }, 1);
  CHECK(threads == std::set{std::this_thread::get_id()});
}
