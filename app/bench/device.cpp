#include "app/bench/device.h"

#include "app/bench/dispatch.h"
#include "app/bench/timing.h"

namespace fascia {
namespace {

constexpr int kRepetitions = 9;

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
  const DispatchChain::Times chain = DispatchChain(programs, 1, 1).measure(DispatchChain::Form::chain, kRepetitions);
  speed.dispatch_us = chain.wall.median;
  speed.dispatch_submit_us = chain.submit.median;
  const gl::Buffer filled("filled", 4 * sizeof(std::uint32_t));
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
