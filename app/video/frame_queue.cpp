#include "app/video/frame_queue.h"

#include <utility>

namespace fascia {

FrameQueue::FrameQueue(std::unique_ptr<FrameSink> sink)
    : sink_(std::move(sink)), worker_([this](std::stop_token stop) { work(std::move(stop)); }) {}

FrameQueue::~FrameQueue() {
  worker_.request_stop();
  if (worker_.joinable()) worker_.join();
}

void FrameQueue::rethrow() {
  if (failed_) std::rethrow_exception(failed_);
}

int FrameQueue::add(std::vector<std::uint8_t> rgba, int count) {
  const std::lock_guard lock(mutex_);
  rethrow();
  if (waiting_.size() == kMost) {
    waiting_.back().count += count;
    return count;
  }
  waiting_.push_back({std::move(rgba), count});
  changed_.notify_one();
  return count - 1;
}

void FrameQueue::work(std::stop_token stop) {
  while (true) {
    Frame frame;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stop, [&] { return !waiting_.empty() || ends_; });
      if (stop.stop_requested() || waiting_.empty()) return;
      frame = std::move(waiting_.front());
      waiting_.pop_front();
    }
    try {
      for (int k = 0; k < frame.count && !stop.stop_requested(); ++k) sink_->write(frame.rgba);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failed_ = std::current_exception();
      return;
    }
  }
}

void FrameQueue::finish() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    changed_.notify_one();
  }
  worker_.join();
  rethrow();
  sink_->finish();
}

}  // namespace fascia
