// The implementation of a public simulation.
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
    std::vector<GrabSpring> springs;  // initial ones: targets are the original places of the vertices
    Eigen::Vector3d center;           // place of the center at the start of the grab [m]
    Eigen::Vector3d target;           // current target of the center [m]
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
  /// Calls work(simulation) with its context current, and translates errors.
  template <class F>
  decltype(auto) call(F&& work) {
    return translated([&]() -> decltype(auto) {
      context.impl()->enter();
      return work(*simulation);
    });
  }
  /// Creates a grab of vertices with their shares. Throws Error if there are none.
  Grab take(const std::vector<PatchVertex>& patch, double stiffness);
  Held& find(Grab grab);  // throws Error for an unknown grab
  void pull();            // passes the springs of all grabs to the simulation
};

}  // namespace fascia::api
