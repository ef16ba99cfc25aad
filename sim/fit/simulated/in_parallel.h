// Independent jobs on all cores, or on fewer.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace fascia {

/// Calls job(0) to job(count - 1), each once, on `most` threads at most, the caller's among them. The first exception
/// of a job is thrown after all threads have ended.
template <class Job>
void in_parallel(std::size_t count, const Job& job, std::size_t most = std::thread::hardware_concurrency()) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) job(i);
  };
  const std::size_t threads = std::min(count, std::max<std::size_t>(1, most));
  std::vector<std::future<void>> others;
  for (std::size_t t = 1; t < threads; ++t) others.push_back(std::async(std::launch::async, work));
  std::exception_ptr failed;
  const auto keep = [&](const auto& part) {
    try {
      part();
    } catch (...) {
      if (!failed) failed = std::current_exception();
      next = count;
    }
  };
  keep(work);
  for (std::future<void>& other : others) keep([&] { other.get(); });
  if (failed) std::rethrow_exception(failed);
}

}  // namespace fascia
