// The short form of fuzzing: every seed, every input that broke a reader in the past, and cheap, deterministic
// mutations of both.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/watched_new.h"
#include "tests/support/support.h"

using namespace fascia;
namespace fs = std::filesystem;

namespace {

constexpr int mutations_of_a_target = 4000;

// A count in a file's header must not be trusted. The inputs are at most 100 KB, and zlib can expand them by at most
// 1032.
constexpr std::size_t most_allocated = std::size_t{128} << 20;

std::vector<std::string> contents_of(const fs::path& folder) {
  std::vector<fs::path> paths;
  if (fs::exists(folder))
    std::copy(fs::directory_iterator(folder), fs::directory_iterator(), std::back_inserter(paths));
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> contents;
  for (const fs::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    contents.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return contents;
}

class Mutator {
 public:
  explicit Mutator(std::vector<std::string> seeds) : seeds_(std::move(seeds)) {}

  std::string next() {
    std::string data = pick();
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) change(data);
    return data;
  }

 private:
  std::size_t below(std::size_t end) { return random_() % end; }  // no std distribution: those differ between libraries
  const std::string& pick() { return seeds_[below(seeds_.size())]; }
  std::string piece_of(const std::string& data) {
    const std::size_t begin = below(data.size() + 1);
    return data.substr(begin, below(data.size() - begin + 1));
  }

  void change(std::string& data) {
    const std::size_t at = below(data.size() + 1);
    switch (below(6)) {
      case 0:
        data.resize(at);
        break;
      case 1:
        if (at < data.size()) data[at] = static_cast<char>(data[at] ^ (1 << below(8)));
        break;
      case 2:
        data.erase(at, 1 + below(16));
        break;
      case 3:
        data.insert(at, piece_of(data).substr(0, 64));
        break;
      case 4:
        data = data.substr(0, at) + piece_of(pick());
        break;
      default:
        swap_number(data, at);
    }
  }

  /// Replaces the next number of a text by one that is difficult for readers.
  void swap_number(std::string& data, std::size_t at) {
    static constexpr std::array<const char*, 14> numbers = {"0",
                                                            "-1",
                                                            "1",
                                                            "3",
                                                            "127",
                                                            "4294967295",
                                                            "4294967296",
                                                            "2147483648",
                                                            "-9223372036854775808",
                                                            "18446744073709551615",
                                                            "1e308",
                                                            "1e-400",
                                                            "nan",
                                                            "99999999999999999999"};
    constexpr std::string_view digits = "0123456789.-";
    const std::size_t begin = data.find_first_of(digits, at);
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(data.find_first_not_of(digits, begin), data.size());
    data.replace(begin, end - begin, numbers[below(numbers.size())]);
  }

  std::vector<std::string> seeds_;
  std::mt19937 random_{12345};
};

}  // namespace

TEST_CASE("readers accept or refuse: seeds, past failures, and mutations", "[fuzz]") {
  REQUIRE(!fuzz::targets().empty());
  for (const auto& [name, target] : fuzz::targets()) {
    const fs::path folder = test::test_dir() / "fuzz";
    std::vector<std::string> inputs = contents_of(folder / "corpus" / name);
    const std::size_t seeds = inputs.size();
    REQUIRE(seeds > 0);
    const std::vector<std::string> crashes = contents_of(folder / "crashes" / name);
    inputs.insert(inputs.end(), crashes.begin(), crashes.end());

    std::size_t read = 0, refused = 0, largest = 0;
    const auto run = [&](const std::string& input) {
      INFO("target " << name << ", input: " << input);
      test::largest_allocation = 0;
      CHECK_NOTHROW(++(fuzz::run(target, input) ? read : refused));
      CHECK(test::largest_allocation <= most_allocated);
      largest = std::max(largest, test::largest_allocation);
    };
    for (const std::string& input : inputs) run(input);
    Mutator mutator(inputs);
    for (int i = 0; i < mutations_of_a_target; ++i) run(mutator.next());
    std::printf("%-7s %3zu seeds, %2zu kept, %d mutations: %zu read, %zu refused; largest allocation %zu KB\n",
                name.c_str(), seeds, crashes.size(), mutations_of_a_target, read, refused, largest / 1024);
    CHECK(read > 0);
  }
}
