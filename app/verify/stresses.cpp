// The stress recovered at vertices against closed forms, beside the stresses of the tets around.
#include <cmath>
#include <functional>
#include <numbers>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/reference/newton.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kModulus = 1e6, kDegrees = 0.5;  // of each end of the bent bar

Model bar(int cells, ElementOrder elements, const std::vector<Selection>& fixed,
          const std::vector<PrescribedMotion>& motions) {
  // Without lateral contraction sections stay plane.
  return solid(make_box(cells, cells / 4, cells / 4, {1, 0.25, 0.25}),
               material_of(MaterialModel::st_venant_kirchhoff, kModulus, 0), elements, fixed, motions);
}

Selection section(double at) { return BoxSelection{{at - 1e-6, -1, -1}, {at + 1e-6, 1, 1}}; }

/// The ends turn against each other.
Model bent_bar(int cells, ElementOrder elements) {
  std::vector<PrescribedMotion> turns;
  for (const double end : {0.0, 1.0}) {
    PrescribedMotion turn;
    turn.select = section(end);
    turn.axis = Vector3d::UnitZ();
    turn.angle_deg = end == 0 ? -kDegrees : kDegrees;
    turn.center = {end, 0.125, 0.125};
    turns.push_back(turn);
  }
  return bar(cells, elements, {}, turns);
}

Model hanging_bar(int cells, ElementOrder elements) {
  Model model = bar(cells, elements, {section(0)}, {});
  model.gravity = {1, 0, 0};  // strains of 0.1 %
  return model;
}

struct StressErrors {
  double recovered = 0, tets = 0;            // RMS at vertices, relative
  double peak_recovered = 0, peak_tets = 0;  // von Mises stress that 1 % of the volume exceeds, over the true one
};

StressErrors errors_of(const Model& model, const State& state, const std::function<double(const Vector3d&)>& exact,
                       double true_peak) {
  const NodalStress stress = nodal_stress(model, state);
  const std::vector<double> of_tets = reference::export_fields(model, state).von_mises;
  StressErrors errors;
  double whole = 0;
  std::vector<double> volumes;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    volumes.push_back(volume_of(model, t));
    for (const std::uint32_t v : model.element(t)) {
      const double truth = exact(model.rest_positions[v]);
      errors.recovered += volumes.back() * std::pow(stress.von_mises[v] - truth, 2);
      errors.tets += volumes.back() * std::pow(of_tets[t] - truth, 2);
      whole += volumes.back() * truth * truth;
    }
  }
  errors.recovered = std::sqrt(errors.recovered / whole);
  errors.tets = std::sqrt(errors.tets / whole);
  errors.peak_recovered = peak_of(stress, model).p99 / true_peak;
  errors.peak_tets = exceeded_by_a_hundredth(of_tets, volumes) / true_peak;
  return errors;
}

}  // namespace

void verify_stresses(Verification& verification) {
  const char* const kTest = "Recovered stress";
  constexpr double kBend = kModulus * 2 * kDegrees * std::numbers::pi / 180, kDensity = 1000;
  struct Loading {
    const char* name;
    const char* truth;
    Model (*model)(int cells, ElementOrder elements);
    double (*exact)(const Vector3d& x);
    double peak;  // [Pa] that 1 % of the volume exceeds
  };
  const Loading loadings[] = {
      {"bar in pure bending", "closed form: E times curvature times distance from the middle", bent_bar,
       [](const Vector3d& x) { return kBend * std::abs(x.y() - 0.125); }, 0.99 * 0.125 * kBend},
      {"bar drawn out by its weight", "closed form: the weight below", hanging_bar,
       [](const Vector3d& x) { return kDensity * (1 - x.x()); }, 0.99 * kDensity}};
  for (const Loading& loading : loadings)
    for (const ElementOrder elements : kElementOrders) {
      const Model model = loading.model(elements == ElementOrder::linear ? 24 : 8, elements);
      const StressErrors errors = errors_of(model, equilibrium(model), loading.exact, loading.peak);
      const std::string name = std::string(loading.name) + ", " + count_of(model) + ": ";
      verification.add({kTest, name + "error of the recovered stress at vertices over that of the tets around", "",
                        errors.recovered / errors.tets, 0, 0.5,
                        std::string(loading.truth) + "; errors of " + number(100 * errors.recovered) + " and " +
                            number(100 * errors.tets) + " %"});
      verification.add({kTest, name + "recovered stress that 1 % of the volume exceeds, over the true one", "",
                        errors.peak_recovered, 0.9, 1.1,
                        std::string(loading.truth) + "; of the tets " + number(errors.peak_tets), false});
    }
}

}  // namespace fascia
