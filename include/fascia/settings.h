// How steps are solved.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// Values out of range, and pairs of method and acceleration that make no sense, are an Error of the call that is
  /// given them.
  struct Settings {
    std::string method = "two_level";  // as in scene files; solver_pairs() lists them
    std::string acceleration = "subspace";
    int iterations = 10;   // per substep, at most; 1 to 10000
    double tolerance = 0;  // relative residual at which a substep's iterations stop, 0 to 1; 0: all of them run
    double time_step = 1.0 / 60.0;  // of one step [s], 1e-6 to 1
    int substeps = 1;               // equal parts of a step, 1 to 1000
    double frame_budget = 0;        // wall time of a step [ms], 0 to 10000: as many iterations as fit; 0: no limit
    int colors = 0;                 // of gauss_seidel, 0 to 64; 0: as many as the mesh needs
    double spectral_radius = 0;     // for chebyshev, 0 to 0.9999; 0: estimated
    int window = 5;                 // earlier iterations that anderson combines, 1 to 10
    // Sizes of the scene per second [1/s], 0 to 1: what is slower falls asleep; 0: nothing does
    double rest_speed = 1e-5;
    bool operator==(const Settings&) const = default;
  };

  /// Method and acceleration of all pairs that can be set, best first.
  FASCIA_EXPORT std::vector<std::pair<std::string, std::string>> solver_pairs();

}  // namespace api
}  // namespace fascia
