// Passes frames from a window to a video. A separate thread writes them, so that no encoder blocks a window; if it is
// too slow, the previous frame is shown longer, and counted.
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
  ~FrameQueue();  // without finish(): the video is discarded
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// Adds the picture, to be shown for `count` frames. Returns the number of frames that repeat another picture: all
  /// but the first, or all if the queue is full. Throws Error if the sink failed.
  int add(std::vector<std::uint8_t> rgba, int count);
  /// Waits until everything is written. Throws Error if the sink failed.
  void finish();

 private:
  struct Frame {
    std::vector<std::uint8_t> rgba;
    int count;
  };
  static constexpr std::size_t kMost = 12;  // waiting frames
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
