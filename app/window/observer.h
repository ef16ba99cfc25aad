// Measures the tissue for the window: requests diagnostics and distributes them, feeds the plots, chooses their point
// and writes the plots to files.
#pragma once
#include <array>
#include <optional>

#include "app/fit/background_fit.h"
#include "app/window/sides.h"

namespace fascia {

class Observer {
 public:
  Observer(Stage& stage, Sides& sides) : stage_(stage), sides_(sides) {}

  void read();    // once a frame, after its steps
  void finish();  // waits for the diagnostics of the last step, which the frames may not have requested
  double residual() const { return residual_; }                                // the latest of the open session
  const std::optional<Diagnostics>& of_open_session() const { return open_; }  // the latest

  /// A click at this pixel of the window's picture. Returns false if no point was to be chosen.
  bool choose_probe(const Eigen::Vector2d& at);
  void write_plots(const Requests& requests);  // the requested files of the plots. Throws Error
  /// Shows measured curves (sim/fit/measured/measurement.h) in the plots; their probe is the point that is followed.
  /// Throws Error.
  void show_measured(const std::filesystem::path& file);

  /// Fits the chosen values of the open scene to the measured curves, in the background, by this program of fascia.
  /// Throws Error.
  void start_fit(const std::filesystem::path& program);
  /// Now and then: true if the plots have news of the fit.
  bool follow_fit();
  void end_fit();  // without a result

 private:
  void follow(const Diagnostics& diagnostics);  // into the plots

  Stage& stage_;
  Sides& sides_;
  std::optional<Diagnostics> open_;
  std::optional<BackgroundFit> fit_;
  double residual_ = 0;
  struct Moment {
    double time = 0;  // simulated [s]
    long steps = 0;   // steps made
  };
  std::array<Moment, 2> asked_;  // of the last requests for diagnostics; at most two are pending
};

}  // namespace fascia
