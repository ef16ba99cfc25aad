// Frames on their way to a video: in order, counted, cancelled or failed, at any speed of the encoder.
#include "app/video/frame_queue.h"

#include <catch2/catch.hpp>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include "base/error.h"

using namespace fascia;

namespace {

/// Frames that arrived, stored outside of the sink, which the queue owns.
struct Record {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<int> frames;  // the first byte of each
  int entered = 0;          // calls of write
  bool open = true;         // false: write() waits
  int fails_at = -1;        // frame at which write() throws
  bool finished = false, gone = false;

  void set_open(bool now) {
    const std::lock_guard lock(mutex);
    open = now;
    changed.notify_all();
  }
  void wait_for(int calls) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return entered >= calls; });
  }
};

class Sink : public FrameSink {
 public:
  explicit Sink(Record& record) : record_(record) {}
  ~Sink() override { record_.gone = true; }
  void write(const std::vector<std::uint8_t>& rgba) override {
    std::unique_lock lock(record_.mutex);
    ++record_.entered;
    record_.changed.notify_all();
    record_.changed.wait(lock, [&] { return record_.open; });
    if (rgba[0] == record_.fails_at) throw Error("the encoder", "died", "");
    record_.frames.push_back(rgba[0]);
  }
  void finish() override { record_.finished = true; }

 private:
  Record& record_;
};

std::vector<std::uint8_t> picture(int number) { return {static_cast<std::uint8_t>(number), 0, 0, 255}; }

}  // namespace

TEST_CASE("frames arrive in their order, as often as they are shown") {
  Record record;
  FrameQueue queue(std::make_unique<Sink>(record));
  CHECK(queue.add(picture(1), 1) == 0);
  CHECK(queue.add(picture(2), 3) == 2);  // two frames repeat the one before
  CHECK(queue.add(picture(3), 1) == 0);
  queue.finish();
  CHECK(record.frames == std::vector<int>{1, 2, 2, 2, 3});
  CHECK(record.finished);
}

TEST_CASE("frames that a slow encoder drops are replaced by the frame before, and counted") {
  Record record;
  record.open = false;
  FrameQueue queue(std::make_unique<Sink>(record));
  queue.add(picture(0), 1);
  record.wait_for(1);  // the encoder has the frame, and the queue is empty
  std::vector<int> expected{0};
  int waiting = 0, lost = 0;
  for (int i = 1; i <= 20; ++i) {
    const int shown_otherwise = queue.add(picture(i), 2);
    if (shown_otherwise == 1) {
      ++waiting;
      expected.insert(expected.end(), {i, i});
    } else {
      CHECK(shown_otherwise == 2);
      ++lost;
      expected.insert(expected.end(), {waiting, waiting});
    }
  }
  record.set_open(true);
  queue.finish();
  CAPTURE(waiting, lost);
  CHECK(waiting == 12);
  CHECK(lost == 8);
  CHECK(record.frames == expected);
}

TEST_CASE("a failure of the encoder is thrown when frames are added and at the end") {
  Record record;
  record.fails_at = 1;
  FrameQueue queue(std::make_unique<Sink>(record));
  queue.add(picture(0), 1);
  queue.add(picture(1), 1);
  CHECK_THROWS_WITH(queue.finish(), Catch::Contains("the encoder: died"));
  CHECK_THROWS_WITH(queue.add(picture(2), 1), Catch::Contains("the encoder: died"));
  CHECK_FALSE(record.finished);
  CHECK(record.frames == std::vector<int>{0});
}

TEST_CASE("a queue that is not finished cancels its video") {
  Record record;
  record.open = false;
  std::optional<FrameQueue> queue;
  queue.emplace(std::make_unique<Sink>(record));
  for (int i = 0; i < 5; ++i) queue->add(picture(i), 100);
  record.wait_for(1);
  record.set_open(true);
  queue.reset();
  CHECK(record.gone);
  CHECK_FALSE(record.finished);
}
