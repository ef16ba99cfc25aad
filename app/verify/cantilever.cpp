// A beam that bends under its weight by a quarter of its length, at Poisson's ratios up to 0.499, and its frequencies.
#include <array>
#include <cmath>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/accuracy/frequencies.h"

namespace fascia {
namespace {

struct Truth {
  double nu, tip, half_gap;  // [m]
};
constexpr Truth kTips[] = {
    {0.3, -0.237290, 0.000268}, {0.45, -0.232667, 0.000438}, {0.49, -0.230663, 0.000537}, {0.499, -0.230136, 0.000765}};
const char* const kTipSource =
    "mean of two finer solutions that bracket it, on 9,216 quadratic tets graded to the support: without and with "
    "averaged pressure; half their gap: ";

double tip_of(const Model& model) { return displacement_at(model, equilibrium(model), {1, 0.125, 0.125}).y(); }

}  // namespace

void verify_cantilever(Verification& verification) {
  const char* const kTest = "Cantilever";
  Chart chart{"Hanging beam: error of the tip",
              {"vertices", true, {}},
              {"relative error of the tip's displacement [-]", true, {}},
              {},
              {}};
  for (std::size_t k = 0; k < std::size(kTips); ++k) {
    const auto [nu, tip, half_gap] = kTips[k];
    for (const ElementOrder elements : kElementOrders) {
      const bool quadratic = elements == ElementOrder::quadratic;
      Series series = series_of(elements, nu, static_cast<int>(k));
      std::vector<int> resolutions = quadratic ? std::vector{4, 8, 12} : std::vector{8, 16, 24};
      if (verification.full) resolutions.push_back(quadratic ? 20 : 36);
      for (const int cells : resolutions) {
        const Model model = hanging_beam(cells, nu, elements);
        const double found = tip_of(model), error = found / tip - 1;
        series.points.emplace_back(static_cast<double>(model.rest_positions.size()), std::abs(error));
        if (cells != (quadratic ? 12 : 24)) continue;
        const std::string source = number(1000 * tip) + " mm, " + kTipSource + number(1000 * half_gap) + " mm";
        VerifiedNumber finding{
            kTest, count_of(model) + ", nu = " + number(nu) + ": tip", "mm", 1000 * found, 1010 * tip, 990 * tip,
            source};
        if (nu > 0.495) finding.low = 1020 * tip, finding.high = 980 * tip;
        finding.judged = quadratic;  // linear tets lock, as expected
        verification.add(finding);
      }
      chart.series.push_back(std::move(series));
    }
  }
  verification.draw(kTest, "cantilever", chart);
}

void verify_frequencies(Verification& verification) {
  struct Row {
    double nu;
    std::array<double, 6> truth;  // [Hz]
  };
  // CalculiX 2.20: C3D20R with consistent masses on 16 x 4 x 4 to 40 x 10 x 10 cells, graded to the support and the
  // surface, extrapolated; known to 0.02 %. C3D20 has the same limits at 0.49.
  const Row rows[] = {{0.3, {1.2315, 1.2315, 4.5207, 6.2363, 6.2363, 7.9558}},
                      {0.49, {1.2496, 1.2496, 4.2257, 6.1785, 6.1785, 8.0597}}};
  const std::array<const char*, 6> names{"first bending, one way",  "first bending, the other way",  "torsion",
                                         "second bending, one way", "second bending, the other way", "axial"};
  for (const Row& row : rows)
    for (const int cells : verification.full ? std::vector{12, 20} : std::vector{12}) {
      const Model model = hanging_beam(cells, row.nu, ElementOrder::quadratic);
      const Eigen::VectorXd found = natural_frequencies(model, 6);
      for (std::size_t k = 0; k < names.size(); ++k) {
        const double truth = row.truth[k];
        verification.add({"Natural frequencies", count_of(model) + ", nu = " + number(row.nu) + ": " + names[k], "Hz",
                          found.size() > 0 ? found[static_cast<Eigen::Index>(k)] : std::nan(""), 0.99 * truth,
                          1.01 * truth,
                          number(truth) + " Hz: extrapolated from CalculiX's C3D20R with consistent masses"});
      }
    }
}

}  // namespace fascia
