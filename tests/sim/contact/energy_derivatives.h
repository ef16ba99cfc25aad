// Whether the gradient of an energy of contact and its blocks are its derivatives, by finite differences.
#pragma once
#include <catch2/catch.hpp>
#include <vector>

#include "sim/contact/contact_block.h"
#include "tests/sim/reference/box_model.h"

namespace fascia::test {

/// `energy`: with evaluate(u, gradient); `blocks`: of its Hessian at `u`.
template <class Energy>
void check_derivatives(const Energy& energy, const std::vector<ContactBlock>& blocks, const Eigen::VectorXd& u) {
  using Eigen::VectorXd;
  constexpr double kStep = 1e-7;
  Random random(9);
  const VectorXd direction = random.vector(u.size());
  const auto at = [&](const VectorXd& place, VectorXd& gradient) {
    gradient = VectorXd::Zero(u.size());
    return energy.evaluate(place, gradient);
  };
  VectorXd gradient, before, after, product = VectorXd::Zero(u.size());
  at(u, gradient);
  const double slope = (at(u + kStep * direction, after) - at(u - kStep * direction, before)) / (2 * kStep);
  const VectorXd change = (after - before) / (2 * kStep);
  for (const ContactBlock& block : blocks)
    product.segment<3>(3 * block.row_vertex) += block.hessian * direction.segment<3>(3 * block.column_vertex);
  CAPTURE(slope, gradient.dot(direction), change.norm(), (product - change).norm());
  CHECK(gradient.norm() > 1);
  CHECK(slope == Approx(gradient.dot(direction)).epsilon(1e-6));
  CHECK((product - change).norm() < 1e-5 * change.norm());
}

}  // namespace fascia::test
