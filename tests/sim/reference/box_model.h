// Models built in code, without files: a box of one material, and random states of it.
#pragma once
#include <Eigen/Geometry>
#include <functional>
#include <random>

#include "sim/mesh/mesh_generate.h"
#include "sim/model/model.h"
#include "sim/reference/newton.h"
#include "tests/support/models.h"

namespace fascia::test {

/// A free box without gravity; every vertex that `fixed` accepts is fixed.
inline Model box_model(
    int nx, int ny, int nz, const Eigen::Vector3d& size, const Material& material,
    const std::function<bool(const Eigen::Vector3d&)>& fixed = [](const Eigen::Vector3d&) { return false; }) {
  Model model;
  model.file_mesh = make_box(nx, ny, nz, size);
  model.rest_positions = model.file_mesh.positions;
  model.tets = model.file_mesh.tets;
  for (std::uint32_t t = 0; t < model.tets.size(); ++t) model.tet_source.push_back(t);
  model.tet_material.assign(model.tets.size(), 0);
  model.materials = {material};
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (fixed(model.rest_positions[v])) model.fixed.push_back(v);
  model.initial_velocity.assign(model.rest_positions.size(), Eigen::Vector3d::Zero());
  model.gravity.setZero();
  return model;
}

inline Material soft(double young_modulus, double poisson_ratio = 0.3, double damping = 0) {
  Material material;
  material.young_modulus = young_modulus;
  material.poisson_ratio = poisson_ratio;
  material.damping = damping;
  return material;
}

inline std::vector<std::uint32_t> vertices_where(const Model& model,
                                                 const std::function<bool(const Eigen::Vector3d&)>& test) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (test(model.rest_positions[v])) found.push_back(v);
  return found;
}

inline std::function<bool(const Eigen::Vector3d&)> on_surface(const Eigen::Vector3d& size) {
  return [size](const Eigen::Vector3d& x) {
    return (x.array() < 1e-9 * size.array()).any() || (x.array() > (1 - 1e-9) * size.array()).any();
  };
}

inline Eigen::VectorXd flat(const std::vector<Eigen::Vector3d>& vectors) {
  return Eigen::Map<const Eigen::VectorXd>(vectors[0].data(), 3 * static_cast<Eigen::Index>(vectors.size()));
}

/// Numbers in [-1, 1] from a fixed seed.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  Eigen::Vector3d vector() { return {(*this)(), (*this)(), (*this)()}; }
  Eigen::VectorXd vector(Eigen::Index size) {
    return Eigen::VectorXd::NullaryExpr(size, [&] { return (*this)(); });
  }
  Eigen::Matrix3d rotation() { return Eigen::AngleAxisd(3.1 * (*this)(), vector().normalized()).toRotationMatrix(); }

 private:
  std::mt19937 engine_;
};

}  // namespace fascia::test
