#include "app/bench/device.h"

#include <chrono>

#include "app/bench/timing.h"
#include "gl/compute_pass.h"

namespace fascia {
namespace {

constexpr int kRepetitions = 9;
constexpr int kDispatches = 200;  // in a row

double median_of(const std::function<double()>& measure) {
  std::vector<double> values;
  for (int i = 0; i <= kRepetitions; ++i)
    if (const double value = measure(); i > 0) values.push_back(value);  // the first run is a warm-up
  return spread_of(std::move(values)).median;
}

}  // namespace

DeviceSpeed measure_device(gl::ProgramCache& programs, std::size_t bytes) {
  DeviceSpeed speed;
  {
    const gl::Buffer from("copied", bytes);
    gl::Buffer to("copy", bytes);
    warm_up([&] { to.copy(from, bytes); });
    const double ms = median_of([&] { return milliseconds_of([&] { to.copy(from, bytes); }); });
    speed.copy_gigabytes_per_s = 2e-6 * static_cast<double>(bytes) / ms;
  }
  const gl::Buffer filled("filled", 4 * sizeof(std::uint32_t));
  const gl::ComputePass pass(programs.compute("common/fill.comp"), {{"filled", &filled}}, 1,
                             {{"word_0", 0}, {"word_1", 0}, {"word_2", 0}, {"word_3", 0}});
  std::vector<double> submitted;
  speed.dispatch_us = median_of([&] {
    return 1e3 / kDispatches * milliseconds_of([&] {
             const auto start = std::chrono::steady_clock::now();
             for (int i = 0; i < kDispatches; ++i) pass.run();
             submitted.push_back(
                 std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() /
                 kDispatches);
           });
  });
  speed.dispatch_submit_us = spread_of(std::move(submitted)).median;
  speed.read_us = median_of([&] {
    return 1e3 * milliseconds_of([&] {
             std::uint32_t word = 0;
             filled.download(0, sizeof word, &word);
           });
  });
  return speed;
}

Table table_of(const DeviceSpeed& speed) {
  Table table;
  table.notes = {
      "copy: a large buffer to another one, bytes read and written; dispatch: of one work group, one after the other, "
      "each waiting for the one before it; submit: what of that the CPU is busy with; read: of four bytes"};
  table.columns = {"copy_gigabytes_per_s", "dispatch_us", "dispatch_submit_us", "read_us"};
  table.rows = {{speed.copy_gigabytes_per_s, speed.dispatch_us, speed.dispatch_submit_us, speed.read_us}};
  return table;
}

}  // namespace fascia
