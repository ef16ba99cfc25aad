// Scenes for tests of the public interface, built only with that interface.
#pragma once
#include <cmath>
#include <string>

#include "fascia/fascia.h"

namespace fascia::test {

/// One context for all tests of the program, so that kernels are compiled once.
inline Context context() {
  static const Context made = Context::own("osmesa");
  return made;
}

/// A cube of 0.1 m that stands on its lower side.
inline Body standing_cube(int cells = 2) {
  Body cube;
  cube.name = "cube";
  cube.mesh = make_box(cells, cells, cells, {0.1, 0.1, 0.1});
  cube.material = {.young_modulus = 1e4, .poisson_ratio = 0.3, .damping = 0.02};
  for (std::uint32_t v = 0; v < cube.mesh.vertex_count(); ++v)
    if (cube.mesh.positions[3 * v + 1] == 0) cube.fixed.push_back(v);
  return cube;
}

inline Scene scene_of(Body body) {
  Scene scene;
  scene.bodies.push_back(std::move(body));
  return scene;
}

inline double norm(const Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

/// The text of the Error that `work` throws; "" if there is none.
template <class F>
std::string error_of(F&& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace fascia::test
