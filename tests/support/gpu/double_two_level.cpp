#include "tests/support/gpu/double_two_level.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

#include "sim/coarse/coarse_matrix.h"
#include "sim/material/law.h"
#include "sim/material/symmetric_eigen.h"

namespace fascia::test {
namespace {

using namespace Eigen;

Index at(std::uint32_t vertex) { return 3 * static_cast<Index>(vertex); }

// The diagonal blocks of the Hessian without the negative part of the geometric term.
std::vector<Matrix3d> blocks(const Model& model, const VectorXd& u, const VectorXd& mass, double h) {
  std::vector<Matrix3d> result;
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    result.push_back(mass[3 * static_cast<Index>(v)] * Matrix3d::Identity());
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Tet& tet = model.tets[t];
    const auto& x = model.rest_positions;
    const LinearTet rest(Corners{x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]});
    const Corners corners{u.segment<3>(at(tet[0])), u.segment<3>(at(tet[1])), u.segment<3>(at(tet[2])),
                          u.segment<3>(at(tet[3]))};
    const Material& material = model.materials[model.tet_material[t]];
    // For laws beyond the Green strain the block has no geometric term.
    const Matrix3d stress =
        !law_of(material.model).of_strain
            ? Matrix3d::Zero()
            : reference::second_piola_stress(reference::green_strain_matrix(rest, corners), material);
    const auto d = reference::elastic(rest, corners, material, 0, Matrix3d::Zero(), true, false);
    for (int a = 0; a < 4; ++a) {
      const Vector3d b = rest.gradients.col(a);
      result[tet[static_cast<std::size_t>(a)]] +=
          h * h *
          (d.hessian.block<3, 3>(3 * a, 3 * a) - rest.volume * std::min(0.0, b.dot(stress * b)) * Matrix3d::Identity());
    }
  }
  return result;
}

// As stored on the GPU: with a slightly raised diagonal, and as S C S with 16-bit integers in C, whose diagonal is
// constant.
MatrixXd inverse_in_sixteen_bits(MatrixXd matrix) {
  matrix.diagonal() *= 1 + 1e-7;
  const MatrixXd inverse = matrix.inverse();
  const VectorXd scale = (inverse.diagonal() / 32767).cwiseSqrt();
  return inverse.cwiseQuotient(scale * scale.transpose())
      .array()
      .round()
      .matrix()
      .cwiseProduct(scale * scale.transpose());
}

}  // namespace

DoubleTwoLevel::DoubleTwoLevel(const Model& model, double h, const VectorXd& start, const VectorXd& predicted)
    : model_(model),
      h_(h),
      system_(model),
      u_(start),
      predicted_(predicted),
      mass_(start.size()),
      space_(make_coarse_space(model, coarse_node_target(model.tets.size()))),
      gather_(make_coarse_gather(model, space_)),
      coarse_inverse_(inverse_in_sixteen_bits(coarse_matrix(model, space_, h))) {
  const std::vector<double> masses = lumped_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v) mass_.segment<3>(3 * static_cast<Index>(v)).setConstant(masses[v]);
  for (const Matrix3d& block : blocks(model, start, mass_, h)) block_inverse_.push_back(block.inverse());
}

VectorXd DoubleTwoLevel::gradient(const VectorXd& u, double& objective) const {
  VectorXd g;
  const VectorXd d = u - predicted_;
  objective = h_ * h_ * system_.evaluate(u, {}, g) + 0.5 * d.dot(mass_.cwiseProduct(d));
  g = h_ * h_ * g + mass_.cwiseProduct(d);
  for (std::size_t v = 0; v < model_.rest_positions.size(); ++v)
    if (system_.first_dof()[v] < 0) g.segment<3>(3 * static_cast<Index>(v)).setZero();
  return g;
}

VectorXd DoubleTwoLevel::fine(const VectorXd& gradient) const {
  VectorXd z(gradient.size());
  for (std::size_t v = 0; v < block_inverse_.size(); ++v) {
    const Index i = 3 * static_cast<Index>(v);
    z.segment<3>(i) = block_inverse_[v] * gradient.segment<3>(i);
  }
  return z;
}

VectorXd DoubleTwoLevel::coarse(const VectorXd& gradient) const {
  const Index n = space_.node_count;
  std::vector<Matrix3d> rotations;
  VectorXd load = VectorXd::Zero(3 * n), z = VectorXd::Zero(gradient.size());
  for (std::uint32_t j = 0; j < n; ++j) {
    Matrix3d mean = Matrix3d::Identity();
    for (std::uint32_t k = gather_.begin[j]; k < gather_.begin[j + 1]; ++k)
      mean += u_.segment<3>(at(gather_.vertex[k])) * gather_.gradient[k].transpose();
    const JacobiSVD<Matrix3d> svd(mean, ComputeFullU | ComputeFullV);
    Matrix3d sign = Matrix3d::Identity();
    sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    rotations.push_back(svd.matrixU() * sign * svd.matrixV().transpose());
  }
  for (std::uint32_t v = 0; v + 1 < space_.begin.size(); ++v)
    for (std::uint32_t k = space_.begin[v]; k < space_.begin[v + 1]; ++k)
      load.segment<3>(at(space_.node[k])) +=
          space_.weight[k] * (rotations[space_.node[k]].transpose() * gradient.segment<3>(at(v)));
  const VectorXd x = coarse_inverse_ * load;
  for (std::uint32_t v = 0; v + 1 < space_.begin.size(); ++v)
    for (std::uint32_t k = space_.begin[v]; k < space_.begin[v + 1]; ++k)
      z.segment<3>(at(v)) += space_.weight[k] * (rotations[space_.node[k]] * x.segment<3>(at(space_.node[k])));
  return z;
}

void DoubleTwoLevel::begin(const VectorXd& base) {
  last_step_ = u_ - base;
  previous_gradient_ = gradient(base, objective_);
  inertia_ = true;
}

void DoubleTwoLevel::descend(Acceleration acceleration) {
  const bool split = acceleration == Acceleration::subspace,
             remembers = acceleration != Acceleration::none && !inertia_;
  inertia_ = false;
  double objective = 0;
  const VectorXd g = gradient(u_, objective);
  if (objective > objective_) {
    const double slope_before = last_step_.dot(previous_gradient_), slope = last_step_.dot(g);
    const double excess = objective - objective_ - slope_before,
                 exponent = std::clamp((slope - slope_before) / excess, 2.0, 4.0);
    const double kept =
        slope_before < 0 ? std::min(0.5, std::pow(-slope_before / (exponent * excess), 1 / (exponent - 1))) : 0;
    u_ -= (1 - kept) * last_step_;
    last_step_ *= kept;
    return;
  }
  objective_ = objective;
  MatrixXd z(g.size(), split ? 3 : 2);
  z.col(0) = split ? fine(g) : VectorXd(fine(g) + coarse(g));
  if (split) z.col(1) = coarse(g);
  const Index last = z.cols() - 1, corrections = split ? 2 : 1;
  MatrixXd a = MatrixXd::Zero(z.cols(), z.cols());
  for (Index k = 0; k < corrections; ++k) {
    const VectorXd hz = h_ * h_ * system_.hessian_times(u_, {}, z.col(k)) + mass_.cwiseProduct(z.col(k));
    for (Index i = 0; i < corrections; ++i) a(i, k) = z.col(i).dot(hz);
  }
  z.col(last) = last_step_;
  const VectorXd y = g - previous_gradient_;  // approximates H p
  for (Index i = 0; i < corrections; ++i) a(i, last) = a(last, i) = z.col(i).dot(y);
  a(last, last) = std::max(last_step_.dot(y), last_step_.dot(mass_.cwiseProduct(last_step_)));
  VectorXd scale = a.diagonal().cwiseAbs().cwiseSqrt();
  if (!remembers) scale[last] = 0;
  for (double& s : scale) s = s > 0 ? 1 / s : 0;  // the last step was discarded entirely
  const SymmetricEigen eigen = symmetric_eigen(scale.asDiagonal() * a * scale.asDiagonal());
  const VectorXd b = -(scale.asDiagonal() * (z.transpose() * g));
  const VectorXd modes = (eigen.vectors.transpose() * b).cwiseQuotient(eigen.values.cwiseAbs().cwiseMax(0.03));
  const VectorXd step = z * (scale.asDiagonal() * (eigen.vectors * modes));
  u_ += step;
  last_step_ = step;
  previous_gradient_ = g;
}

}  // namespace fascia::test
