// What tests of contact on the GPU share: settings, tissue and tools.
#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "sim/gpu/solver.h"
#include "sim/mesh/mesh_generate.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

namespace fascia::test {

inline SolverSettings two_level(int iterations = 10) {
  SolverSettings settings;
  settings.method = Method::two_level;
  settings.acceleration = Acceleration::subspace;
  settings.iterations = iterations;
  settings.time_step = 1.0 / 60;
  return settings;
}

/// Of tissue that does not fall asleep.
inline SolverSettings awake(Integrator integrator, double steps_per_second = 60) {
  SolverSettings settings = two_level();
  settings.integrator = integrator;
  settings.time_step = 1 / steps_per_second;
  settings.rest_speed = 0;
  return settings;
}

inline Material soft_tissue(double young_modulus, double damping = 0) {
  Material material;
  material.young_modulus = young_modulus;
  material.damping = damping;
  return material;
}

inline Material squared(double young_modulus) {
  Material material = soft_tissue(young_modulus, 0.05);
  material.model = MaterialModel::squared;
  return material;
}

inline Tool tool(const std::string& name, const ToolShape& shape, double friction,
                 std::vector<Instrument::Key> path = {{}}) {
  Tool tool;
  tool.name = name;
  tool.shape = shape;
  tool.friction = friction;
  tool.path = std::move(path);
  return tool;
}

inline Model cube(double size, int cells, const Material& material) {
  Model model = make_model(make_box(cells, cells, cells, {size, size, size}), material,
                           [](const Eigen::Vector3d&) { return false; });
  model.gravity = {0, -9.81, 0};
  return model;
}

/// States of a solver after `before` steps, and of it and of another one that goes on from there, after `more` steps.
struct Repeated {
  State middle, here, elsewhere;
};
inline Repeated repeated(Gpu& gpu, const Model& model, int before, int more) {
  GpuSolver first(gpu.programs, model, two_level());
  for (int i = 0; i < before; ++i) first.step();
  const State middle = first.download();
  first.upload(middle);
  GpuSolver second(gpu.programs, model, two_level());
  second.upload(middle);
  for (GpuSolver* solver : {&first, &second})
    for (int i = 0; i < more; ++i) solver->step();
  return {middle, first.download(), second.download()};
}

}  // namespace fascia::test
