// Frames on their way from a window to a video. A thread of its own brings them there, so that no encoder holds up a
// window; of those that it cannot keep up with the one before is shown for longer, and counted.
#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "app/video/frame_sink.h"

namespace fascia {

class FrameQueue {
 public:
  explicit FrameQueue(std::unique_ptr<FrameSink> sink);
  ~FrameQueue();  // without finish(): the video is given up
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// The picture, shown for `count` frames. Returns how many of them the video shows another picture for: of more than
  /// one all but the first, and all where there is no room. Throws Error when the sink failed.
  int add(std::vector<std::uint8_t> rgba, int count);
  /// Waits until all is written. Throws Error when the sink failed.
  void finish();

 private:
  struct Frame {
    std::vector<std::uint8_t> rgba;
    int count;
  };
  static constexpr std::size_t kMost = 12;  // waiting
  void work(std::stop_token stop);
  void rethrow();

  std::unique_ptr<FrameSink> sink_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Frame> waiting_;
  std::exception_ptr failed_;
  bool ends_ = false;
  std::jthread worker_;
};

}  // namespace fascia
