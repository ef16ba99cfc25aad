// fascia bench dispatch: what a dispatch costs that waits for the one before it, as almost every dispatch of a step
// does, over the size of its work and the number of its buffers.
#pragma once
#include "app/bench/bench.h"
#include "app/bench/timing.h"

namespace fascia {

/// Tiny dispatches, each of which adds one to the words that the one before it has stored.
class DispatchChain {
 public:
  static constexpr std::uint32_t kLength = 200;

  enum class Form {
    chain,         // with the barriers of a step
    unordered,     // without barriers: the counts may be wrong
    one_dispatch,  // of as much work as the whole chain
  };
  struct Times {
    Spread wall, submit;    // of a dispatch of the chain [us]: all of it, and the part that occupies the CPU
    Spread device;          // the same as wall by timestamps of the device; 0 where it has none
    std::uint64_t counted;  // by all words together in the first run
  };

  /// `buffers`: 1, 4, 8 or 14 of a dispatch; one is stored into, the others are read. Throws Error.
  DispatchChain(gl::ProgramCache& programs, std::uint32_t work_items, std::uint32_t buffers,
                std::uint32_t length = kLength);

  /// Whether the device has a kernel with so many buffers.
  static bool serves(const gl::ProgramCache& programs, std::uint32_t buffers);
  Times measure(Form form, int repetitions);
  /// What Times::counted is, except without barriers.
  std::uint64_t count() const { return std::uint64_t{work_items_} * length_; }

 private:
  void run(Form form);

  std::uint32_t work_items_, length_;
  gl::Buffer words_;
  std::vector<gl::Buffer> inputs_;
  std::unique_ptr<gl::ComputePass> link_, all_;
};

/// Writes dispatch.csv and, unless quiet, prints a table on standard output. Returns a line for each chain that counted
/// wrong. Throws Error or Interrupted.
std::vector<std::string> bench_dispatch(Bench& bench);

}  // namespace fascia
