// The times of every frame of a window and of its parts (--frame-log), for `fascia bench window` and for anyone who
// asks why a window is slow. Without a file nothing is measured or kept.
#pragma once
#include <Eigen/Core>
#include <array>
#include <chrono>
#include <filesystem>
#include <vector>

namespace fascia {

class FrameLog {
 public:
  /// In the order in which a frame does them. `present`: from the picture's buffer to the window.
  enum class Part { panels, steps, scene, overlay, present };
  static constexpr std::size_t kParts = 5;

  /// What a frame showed.
  struct Shown {
    int steps = 0;
    double simulated = 0;           // by these steps [s]
    bool compiled = false;          // kernels, during the steps
    bool fused = false;             // kernels of a step are fused
    int quality = 0;                // levels below the full quality
    Eigen::Vector2d pointer{0, 0};  // the last place of the mouse that the frame took into account [pixels]
  };

  explicit FrameLog(std::filesystem::path file) : file_(std::move(file)) {}

  /// `elapsed` [s] since the previous frame began.
  void begin(double elapsed);
  void end_of(Part part);
  void end(const Shown& shown);
  /// One row per frame; times of day in seconds of the system's steady clock, which all processes share. Throws Error.
  void write() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Row {
    Clock::time_point ended;
    double elapsed;
    std::array<double, kParts> parts{};  // [ms]
    Shown shown;
  };

  std::filesystem::path file_;
  std::vector<Row> rows_;
  Clock::time_point last_;
};

}  // namespace fascia
