// Default names for files: with the time, and never the name of an existing file.
#include "base/dated_name.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <regex>

#include "tests/support/support.h"

using namespace fascia;
namespace fs = std::filesystem;

namespace {

/// The local time in a name [s], or -1.
std::time_t time_of(const std::string& name) {
  std::tm local{};
  if (std::sscanf(name.c_str(), "fascia-%4d%2d%2d-%2d%2d%2d", &local.tm_year, &local.tm_mon, &local.tm_mday,
                  &local.tm_hour, &local.tm_min, &local.tm_sec) != 6)
    return -1;
  local.tm_year -= 1900;
  local.tm_mon -= 1;
  local.tm_isdst = -1;
  return std::mktime(&local);
}

}  // namespace

TEST_CASE("a dated name has the time, and a number where there is a file of that second") {
  const fascia::test::TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const std::time_t first = std::time(nullptr);
  for (int i = 0; i < 20; ++i) {
    const std::string name = dated_name(".png").string();
    CAPTURE(i, name);
    CHECK(std::regex_match(name, std::regex(R"(fascia-\d{8}-\d{6}(-\d+)?\.png)")));
    CHECK(time_of(name) >= first);
    CHECK(time_of(name) <= std::time(nullptr));
    CHECK_FALSE(fs::exists(name));
    std::ofstream(name) << i;
  }
  const auto made = std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
  fs::current_path(before);
  CHECK(made == 20);
}

TEST_CASE("numbers of one second begin at 2") {
  const fascia::test::TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  std::string first, second;
  do {  // until both names have the same second
    first = dated_name(".csv").string();
    std::ofstream(first) << "x";
    second = dated_name(".csv").string();
  } while (time_of(first) != time_of(second));
  fs::current_path(before);
  CHECK(second == first.substr(0, first.size() - 4) + "-2.csv");
}
