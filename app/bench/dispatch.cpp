#include "app/bench/dispatch.h"

#include <chrono>
#include <iostream>
#include <numeric>

#include "gl/bindings.h"
#include "gl/timing/stopwatch.h"

namespace fascia {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

Cell digits(double microseconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", microseconds);
  return text;
}

}  // namespace

DispatchChain::DispatchChain(gl::ProgramCache& programs, std::uint32_t work_items, std::uint32_t buffers,
                             std::uint32_t length)
    : work_items_(work_items), length_(length), words_("chain", sizeof(std::uint32_t) * work_items * length) {
  gl::ComputePass::Bindings bindings{{"chain", &words_}};
  inputs_.reserve(buffers);
  for (std::uint32_t k = 0; k + 1 < buffers; ++k) {
    inputs_.emplace_back("chain_input", sizeof(std::uint32_t) * work_items);
    bindings.emplace_back("input_" + std::to_string(k), &inputs_.back());
  }
  const gl::Program& program =
      programs.compute("common/dispatch_chain.comp", {{"INPUTS", std::to_string(inputs_.size())}});
  const gl::ComputePass::Constants constants{{"items", work_items}};
  link_ = std::make_unique<gl::ComputePass>(program, bindings, work_items, constants);
  all_ = std::make_unique<gl::ComputePass>(program, bindings, work_items * length, constants);
}

bool DispatchChain::serves(const gl::ProgramCache& programs, std::uint32_t buffers) {
  const gl::Device& device = gl::device();
  return programs.load_path() == gl::LoadPath::storage
             ? buffers <= static_cast<std::uint32_t>(device.max_compute_storage_blocks)
             : buffers <= static_cast<std::uint32_t>(device.max_compute_textures) + 1;
}

void DispatchChain::run(Form form) {
  const gl::KeptBindings kept;  // as in a step
  if (form == Form::one_dispatch) {
    all_->run();
    return;
  }
  for (std::uint32_t i = 0; i < length_; ++i) {
    if (form == Form::unordered) words_.shader_access() = {};  // so that no barrier is missing
    link_->run();
  }
}

DispatchChain::Times DispatchChain::measure(Form form, int repetitions) {
  Times times{};
  words_.clear();
  run(form);  // also compiles the kernel
  const std::vector<std::uint32_t> words = words_.read<std::uint32_t>();
  times.counted = std::accumulate(words.begin(), words.end(), std::uint64_t{0});
  warm_up([&] { run(form); });
  std::vector<double> wall, submit, device;
  for (int turn = 0; turn < repetitions; ++turn) {
    gl::Stopwatch stopwatch;
    const auto start = Clock::now();
    run(form);
    submit.push_back(microseconds_since(start) / length_);
    stopwatch.mark("chain");
    gl::Finish();
    wall.push_back(microseconds_since(start) / length_);
    if (gl::device().timestamp_bits > 0) device.push_back(1e3 * stopwatch.laps().front().second / length_);
  }
  times.wall = spread_of(std::move(wall));
  times.submit = spread_of(std::move(submit));
  times.device = spread_of(std::move(device));
  return times;
}

std::vector<std::string> bench_dispatch(Bench& bench) {
  using Form = DispatchChain::Form;
  const std::uint32_t length = bench.full_or_quick(DispatchChain::kLength, 20u);
  const int repetitions = bench.full_or_quick(25, 3);
  const bool timestamps = gl::device().timestamp_bits > 0;
  Table table, shown;
  table.notes = {
      "chains of " + std::to_string(length) +
          " dispatches, each of which adds one to the words that the one before it has stored; medians of " +
          std::to_string(repetitions) + " runs; _low, _high: a tenth is below, above",
      "_us: microseconds of a dispatch; chain: with the barriers of a step; unordered: without; one_dispatch: "
      "one with the work of the whole chain; submit: what of the chain the CPU is busy with",
      std::string("_device_us: between timestamps of the device, ") +
          (timestamps ? "the others by the clock" : "which this one does not have")};
  table.columns = {"work_items",
                   "buffers",
                   "dispatches",
                   "counted",
                   "chain_us",
                   "chain_us_low",
                   "chain_us_high",
                   "unordered_us",
                   "one_dispatch_us",
                   "submit_us",
                   "chain_device_us",
                   "unordered_device_us",
                   "one_dispatch_device_us"};
  shown.columns = {"work items", "buffers", "chain", "without barriers", "one dispatch", "submit", "chain, device"};
  std::vector<std::string> failures;
  for (const std::uint32_t work_items : {1u, 64u, 1024u, 16384u})
    for (const std::uint32_t buffers : {1u, 4u, 8u, 14u}) {
      bench.stop_if_interrupted();
      const std::string name = std::to_string(work_items) + " work items, " + std::to_string(buffers) + " buffers";
      if (!DispatchChain::serves(*bench.graphics.programs, buffers)) {
        bench.say("left out, " + name + ": more than a kernel may have on this device");
        continue;
      }
      DispatchChain chain(*bench.graphics.programs, work_items, buffers, length);
      const DispatchChain::Times ordered = chain.measure(Form::chain, repetitions),
                                 unordered = chain.measure(Form::unordered, repetitions),
                                 one = chain.measure(Form::one_dispatch, repetitions);
      std::vector<Cell> row{work_items,
                            buffers,
                            length,
                            static_cast<double>(ordered.counted) / work_items,
                            ordered.wall.median,
                            ordered.wall.low,
                            ordered.wall.high,
                            unordered.wall.median,
                            one.wall.median,
                            ordered.submit.median};
      for (const DispatchChain::Times* times : {&ordered, &unordered, &one})
        row.push_back(timestamps ? Cell(times->device.median) : Cell());
      table.rows.push_back(std::move(row));
      shown.rows.push_back({work_items, buffers, digits(ordered.wall.median), digits(unordered.wall.median),
                            digits(one.wall.median), digits(ordered.submit.median),
                            timestamps ? digits(ordered.device.median) : Cell("-")});
      for (const auto& [form, times] : {std::pair("a chain", &ordered), std::pair("one dispatch", &one)})
        if (times->counted != chain.count())
          failures.push_back(name + ": " + form + " counted " + std::to_string(times->counted) + " instead of " +
                             std::to_string(chain.count()));
    }
  bench.write("dispatch", table);
  if (!bench.options.quiet)
    std::cout << "microseconds of a dispatch, medians of " << repetitions << " runs of " << length << " dispatches\n"
              << aligned(shown);
  return failures;
}

}  // namespace fascia
