// What is behind a public simulation.
#pragma once
#include <map>
#include <vector>

#include "api/context.h"
#include "api/error.h"
#include "fascia/simulation.h"
#include "sim/grab/grab_patch.h"
#include "sim/simulation/simulation.h"

namespace fascia::api {

struct Simulation::Impl {
  struct Held {
    std::vector<GrabSpring> springs;  // as taken: targets are where the vertices were
    Eigen::Vector3d center;           // where the center was when it was taken [m]
    Eigen::Vector3d target;           // where it is led [m]
  };

  Context context;
  std::unique_ptr<fascia::Simulation> simulation;
  std::vector<Triangle> surface;
  std::map<std::uint32_t, Held> held;
  std::uint32_t next_grab = 0;

  explicit Impl(Context used) : context(std::move(used)) {}
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void start(fascia::Scene scene, Model model, bool reference, const Progress& progress);
  /// work(simulation) with its context current, and errors translated.
  template <class F>
  decltype(auto) call(F&& work) {
    return translated([&]() -> decltype(auto) {
      context.impl()->enter();
      return work(*simulation);
    });
  }
  /// Vertices with their shares become a grab. Throws Error where there are none.
  Grab take(const std::vector<PatchVertex>& patch, double stiffness);
  Held& find(Grab grab);  // throws Error for a name that means nothing
  void pull();            // hands the springs of all grabs to the simulation
};

}  // namespace fascia::api
