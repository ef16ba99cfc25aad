#include "sim/fit/misfit.h"

#include <cmath>

#include "base/error.h"
#include "sim/fit/simulated/in_parallel.h"
#include "sim/fit/simulated/moved_moments.h"

namespace fascia {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Of inner coordinates, which are logarithms or logits. A central difference of closed forms then has an error of some
// 1e-8.
constexpr double kTangentStep = 2e-5;

}  // namespace

TunedScene::Built Misfit::built(const VectorXd& inner) const { return tuned_.at({inner.begin(), inner.end()}); }

Eigen::Index Misfit::prior_count() const {
  Eigen::Index count = 0;
  for (const Parameter& parameter : tuned_.parameters()) count += parameter.prior.has_value();
  return count;
}

Eigen::Index Misfit::value_count() const { return experiment_.scales().size() + prior_count(); }

std::optional<Misfit::Point> Misfit::at(const VectorXd& inner) const {
  Point point{inner, {}, {}};
  try {
    const TunedScene::Built scene = built(inner);
    ++simulations_;
    std::optional<Experiment::Response> response = experiment_.run(scene.scene, scene.model);
    if (!response) return std::nullopt;
    point.response = std::move(*response);
  } catch (const Error&) {
    if (simulations_ == 0) throw;
    return std::nullopt;  // a value that scenes refuse
  }
  const VectorXd own = experiment_.residuals(point.response.values);
  if (!own.allFinite()) return std::nullopt;
  point.residuals.resize(value_count());
  point.residuals.head(own.size()) = own;
  Eigen::Index row = own.size();
  for (std::size_t p = 0; p < tuned_.parameters().size(); ++p)
    if (const Parameter& parameter = tuned_.parameters()[p]; parameter.prior)
      point.residuals[row++] = parameter.prior_distance(inner[static_cast<Eigen::Index>(p)]);
  return point;
}

bool Misfit::has_tangent(const Point& point, std::size_t parameter) const {
  return point.response.differentiable && tuned_.is_smooth(parameter);
}

bool Misfit::exact(const Point& point) const {
  for (std::size_t p = 0; p < tuned_.parameters().size(); ++p)
    if (!has_tangent(point, p)) return false;
  return true;
}

MatrixXd Misfit::rates(const Point& point) const {
  MatrixXd rates = MatrixXd::Constant(value_count(), point.inner.size(), std::nan(""));
  add_tangents(point, rates);
  add_differences(point, rates);
  const Eigen::Index own = value_count() - prior_count();
  rates.bottomRows(prior_count()).setZero();
  Eigen::Index row = own;
  for (std::size_t p = 0; p < tuned_.parameters().size(); ++p)
    if (const Parameter& parameter = tuned_.parameters()[p]; parameter.prior) {
      const auto column = static_cast<Eigen::Index>(p);
      rates(row++, column) = parameter.prior_rate(point.inner[column]);
    }
  return rates;
}

void Misfit::add_tangents(const Point& point, MatrixXd& rates) const {
  std::vector<Eigen::Index> smooth;
  for (Eigen::Index p = 0; p < point.inner.size(); ++p)
    if (has_tangent(point, static_cast<std::size_t>(p))) smooth.push_back(p);
  if (smooth.empty()) return;
  const auto beside = [&](Eigen::Index p, double step) {
    VectorXd inner = point.inner;
    inner[p] += step;
    return built(inner).model;
  };
  std::vector<ModelPair> pairs;
  for (const Eigen::Index p : smooth) pairs.push_back({beside(p, -kTangentStep), beside(p, kTangentStep)});
  const auto moved = moved_moments(point.response, built(point.inner).model, pairs, kTangentStep);
  if (!moved) return;  // left to differences
  for (std::size_t s = 0; s < smooth.size(); ++s) {
    const VectorXd change = experiment_.values_of(pairs[s].above, (*moved)[s].above) -
                            experiment_.values_of(pairs[s].below, (*moved)[s].below);
    rates.col(smooth[s]).head(change.size()) = change.cwiseProduct(experiment_.scales()) / (2 * kTangentStep);
  }
}

void Misfit::add_differences(const Point& point, MatrixXd& rates) const {
  const Eigen::Index own = value_count() - prior_count();
  std::vector<Eigen::Index> missing;
  for (Eigen::Index p = 0; p < point.inner.size(); ++p)
    if (own > 0 && std::isnan(rates(0, p))) missing.push_back(p);
  std::vector<std::optional<Point>> beside(missing.size());
  std::vector<double> steps(missing.size());
  const double distance = experiment_.simulator().difference_step();
  in_parallel(
      missing.size(),
      [&](std::size_t i) {
        for (const double step : {distance, -distance}) {
          VectorXd inner = point.inner;
          inner[missing[i]] += step;
          steps[i] = step;
          if ((beside[i] = at(inner))) return;
        }
      },
      experiment_.simulator().most_threads());
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (beside[i])
      rates.col(missing[i]).head(own) = (beside[i]->residuals - point.residuals).head(own) / steps[i];
    else
      rates.col(missing[i]).head(own).setZero();  // a parameter that cannot move here
  }
}

}  // namespace fascia
