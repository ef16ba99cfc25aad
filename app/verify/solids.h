// The bodies of the verification tests, and their equilibria by the reference solver.
#pragma once
#include <functional>
#include <vector>

#include "sim/model/grab_spring.h"
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

Material material_of(MaterialModel law, double young_modulus, double poisson_ratio);

/// A body without gravity that is fixed, and moved by `motions`, where the boxes say.
Model solid(const TetMesh& mesh, const Material& material, ElementOrder elements, const std::vector<Selection>& fixed,
            const std::vector<PrescribedMotion>& motions = {});

/// The beam of 1 x 0.25 x 0.25 m that hangs by x = 0 under its weight: E = 1e6 Pa, density 1000, St. Venant-Kirchhoff.
/// `cells`: along x, a quarter of them across.
Model hanging_beam(int cells, double poisson_ratio, ElementOrder elements);

/// Moves all vertices on the surface of a box [0, size] to u(X) and holds them there.
void prescribe_surface(Model& model, const Eigen::Vector3d& size,
                       const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& u);

/// NaN everywhere if the solver does not converge.
State equilibrium(const Model& model, const std::vector<GrabSpring>& springs = {});

/// The displacement of the vertex next to `place`.
Eigen::Vector3d displacement_at(const Model& model, const State& state, const Eigen::Vector3d& place);

std::string count_of(const Model& model);  // "648 quadratic tets"

}  // namespace fascia
