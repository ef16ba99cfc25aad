#include "sim/scene/settings/solver_choice.h"

#include <algorithm>

#include "base/error.h"
#include "base/suggest.h"
#include "sim/material/law.h"

namespace fascia {

const std::vector<MethodInfo>& methods() {
  using M = Method;
  using A = Acceleration;
  static const std::vector<MethodInfo> table = {
      {.method = M::two_level,
       .name = "two_level",
       .label = "Two-level",
       .help = "Every vertex's own block and a coarse space for the motion of large parts, with rotations kept up to "
               "date. Reaches the exact step in few iterations, however fine the mesh and however stiff the tissue.",
       .accelerations = {A::subspace, A::nonlinear_cg, A::anderson, A::none},
       .carries_every_law = true,
       .carries_quadratic = true,
       .carries_contact = true,
       .dispatches = 8},
      {.method = M::vertex_descent,
       .name = "vertex_descent",
       .label = "Vertex block descent",
       .help =
           "Vertex by vertex, each minimizes the energy around it (Chen et al. 2024), one dispatch per vertex color. "
           "Converges to the exact step, fast for short waves, ever more slowly for the bending of large meshes.",
       .accelerations = {A::anderson, A::none},
       .carries_every_law = true,
       .dispatches = 10},
      {.method = M::exact_xpbd,
       .name = "exact_xpbd",
       .label = "XPBD, exact",
       .help = "XPBD that converges to the exact step: the residual of the positions, which XPBD drops, is fed back, "
               "with masses raised by the tension around each vertex. About 1.4 times the cost of Jacobi. Few "
               "iterations on stiff tissue can add energy.",
       .accelerations = {A::anderson, A::none},
       .dispatches = 6},
      {.method = M::mass_splitting,
       .name = "mass_splitting",
       .label = "Jacobi, mass splitting",
       .help = "All tets at once, each with its share of a vertex's mass. As cheap and stable as averaging, keeps "
               "momentum, and converges to within a few percent of the exact step; stiff tissue needs many iterations "
               "or substeps.",
       .accelerations = {A::none, A::chebyshev, A::anderson_positions},
       .in_i3d2019 = true,
       .dispatches = 3},
      {.method = M::gauss_seidel,
       .name = "gauss_seidel",
       .label = "Gauss-Seidel, colored",
       .help =
           "Color by color, each tet sees the corrections before it; one dispatch per color. Converges fastest on soft "
           "tissue with short steps. Stiff tissue with long steps makes it invert tets or diverge: use more substeps.",
       .accelerations = {A::none, A::chebyshev, A::anderson_positions},
       .settings = {"colors"},
       .in_i3d2019 = true,
       .dispatches = 32},
      {.method = M::jacobi,
       .name = "jacobi",
       .label = "Jacobi, averaged",
       .help = "All tets at once, each vertex takes the mean of its tets' corrections: the method of the I3D 2019 "
               "paper. Always stable, but too soft: it does not converge to the material's stiffness, however many "
               "iterations it gets.",
       .accelerations = {A::none, A::chebyshev, A::anderson_positions},
       .in_i3d2019 = true,
       .dispatches = 3},
  };
  return table;
}

const std::vector<AccelerationInfo>& accelerations() {
  using A = Acceleration;
  static const std::vector<AccelerationInfo> table = {
      {A::none,
       "none",
       "none",
       "Every iteration as the method makes it; two_level still chooses the length of its step by the minimum of a "
       "quadratic model.",
       {}},
      {A::chebyshev,
       "chebyshev",
       "Chebyshev",
       "Overshoots by weights that follow from the spectral radius of the iteration (Wang 2015): three dispatches, "
       "nearly free. Falls back to plain iterations when the residual grows. It moves the positions and not the "
       "multipliers: with many iterations the body gets stiffer than its material.",
       {"spectral_radius"}},
      {A::anderson_positions,
       "anderson_positions",
       "Anderson on positions",
       "Combines the last iterations so that the change of positions gets smallest (Peng et al. 2018), as in the I3D "
       "2019 paper. Its limitation: the multipliers are not combined, so the tissue's own compliance is lost: with "
       "many iterations the body gets stiffer than its material.",
       {"window"}},
      {A::anderson,
       "anderson",
       "Anderson",
       "Combines the last iterations so that the change of the whole state gets smallest: positions and, with XPBD "
       "methods, multipliers by the same weights, so the material keeps its stiffness. Memory and dot products grow "
       "with the window.",
       {"window"}},
      {A::nonlinear_cg,
       "nonlinear_cg",
       "Conjugate gradients",
       "Steps along the correction and the last step at once, with the factors that minimize a quadratic model of the "
       "energy. Of a step that raises the energy only a part is kept.",
       {}},
      {A::subspace,
       "subspace",
       "Subspace",
       "As conjugate gradients, but the fine and the coarse correction get a factor each: more robust for stiff, thin "
       "and mixed tissue and more exact in motion, at a slightly higher cost per iteration.",
       {}},
  };
  return table;
}

const MethodInfo& info_of(Method method) {
  return *std::find_if(methods().begin(), methods().end(),
                       [&](const MethodInfo& info) { return info.method == method; });
}

const AccelerationInfo& info_of(Acceleration acceleration) {
  return *std::find_if(accelerations().begin(), accelerations().end(),
                       [&](const AccelerationInfo& info) { return info.acceleration == acceleration; });
}

const std::vector<SolverChoice>& solver_choices() {
  static const std::vector<SolverChoice> choices = [] {
    std::vector<SolverChoice> all;
    for (const MethodInfo& info : methods())
      for (const Acceleration acceleration : info.accelerations) all.push_back({info.method, acceleration});
    return all;
  }();
  return choices;
}

std::vector<SolverChoice> i3d2019_choices() {
  std::vector<SolverChoice> choices;
  for (const SolverChoice& choice : solver_choices())
    if (info_of(choice.method).in_i3d2019) choices.push_back(choice);
  return choices;
}

std::optional<SolverChoice> find_choice(std::optional<std::string_view> method,
                                        std::optional<std::string_view> acceleration) {
  for (const SolverChoice& choice : solver_choices()) {
    if (method && *method != name_of(choice.method)) continue;
    if (acceleration && *acceleration != name_of(choice.acceleration)) continue;
    return choice;
  }
  return std::nullopt;
}

std::string list_of_choices() {
  std::vector<std::string> choices;
  for (const SolverChoice& choice : solver_choices())
    choices.push_back(std::string(name_of(choice.method)) + " with " + name_of(choice.acceleration));
  return join(choices);
}

bool applies(std::string_view setting, const SolverChoice& choice) {
  const auto names = [&](const auto& info) {
    return std::find(info.settings.begin(), info.settings.end(), setting) != info.settings.end();
  };
  const bool special = std::any_of(methods().begin(), methods().end(), names) ||
                       std::any_of(accelerations().begin(), accelerations().end(), names);
  return !special || names(info_of(choice.method)) || names(info_of(choice.acceleration));
}

bool carries(Method method, MaterialModel model) {
  return law_of(model).of_strain || info_of(method).carries_every_law;
}

std::string refusal(Method method, const std::vector<Material>& materials, bool quadratic, bool contact) {
  // First, because another material would not help then.
  if (contact && !info_of(method).carries_contact) return "Needs a scene without contact.";
  for (const Material& material : materials)
    if (!carries(method, material.model))
      return std::string("Needs a material of the model St. Venant-Kirchhoff, and this scene has ") +
             law_of(material.model).label + ".";
  return quadratic && !info_of(method).carries_quadratic ? "Needs linear elements, and this scene has quadratic ones."
                                                         : "";
}

void require_carried(Method method, const std::vector<Material>& materials, const std::string& where) {
  for (const Material& material : materials) {
    if (carries(method, material.model)) continue;
    std::vector<std::string> able;
    for (const MethodInfo& info : methods())
      if (carries(info.method, material.model)) able.push_back(info.name);
    throw Error(where, std::string(name_of(method)) + " does not support the material model " + name_of(material.model),
                "expected one of the methods that do: " + join(able));
  }
}

}  // namespace fascia
