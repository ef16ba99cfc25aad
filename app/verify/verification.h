// fascia verify: the tests that a reviewer asks of a finite-element solver, each with the source of its truth, and
// their report.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "sim/scene/scene.h"

namespace fascia {

/// A measured number and the range in which it passes.
struct VerifiedNumber {
  std::string test;  // "Patch test"
  std::string what;  // the case and the quantity
  std::string unit;  // "": a pure number
  double value = 0;  // NaN: not solved
  double low = 0, high = 0;
  std::string truth;   // what the value should be, and from where
  bool judged = true;  // false: only reported

  bool passed() const { return value >= low && value <= high; }
};

class Verification {
 public:
  /// In the folder and with the context of `with`.
  Verification(Bench& with, bool with_finer_meshes) : bench(with), full(with_finer_meshes) {}

  Bench& bench;
  const bool full;

  void add(VerifiedNumber finding);
  /// Draws the chart into the folder, and into the report under the test.
  void draw(const std::string& test, const std::string& name, const Chart& chart);

  const std::vector<VerifiedNumber>& findings() const { return findings_; }
  int failed() const;
  /// verify.csv and report.html. Throws Error.
  void write() const;

 private:
  struct Drawn {
    std::string test;
    std::filesystem::path file;  // SVG or PNG
  };
  std::vector<VerifiedNumber> findings_;
  std::vector<Drawn> charts_;
};

/// An empty series of a chart over meshes: a color for each Poisson's ratio, solid for quadratic elements.
Series series_of(ElementOrder elements, double poisson_ratio, int color);

/// The tests, in the order of the report.
void verify_patches(Verification& verification);
void verify_cantilever(Verification& verification);
void verify_cook(Verification& verification);
void verify_twist(Verification& verification);
void verify_block(Verification& verification);
void verify_frequencies(Verification& verification);
void verify_orders_in_space(Verification& verification);
void verify_orders_in_time(Verification& verification);
void verify_estimates(Verification& verification);
void verify_estimates_in_time(Verification& verification);
void verify_estimates_in_motion(Verification& verification);
void verify_stresses(Verification& verification);
void verify_gpu(Verification& verification);

}  // namespace fascia
