#include "sim/scene/settings/solver_settings.h"

#include "base/error.h"
#include "base/suggest.h"
#include "sim/material/law.h"

namespace fascia {

const std::vector<Pair>& legal_pairs() {
  using M = Method;
  using A = Acceleration;
  static const std::vector<Pair> pairs = {{M::two_level, A::subspace},
                                          {M::two_level, A::nonlinear_cg},
                                          {M::two_level, A::anderson},
                                          {M::two_level, A::none},
                                          {M::vertex_descent, A::anderson},
                                          {M::vertex_descent, A::none},
                                          {M::exact_xpbd, A::anderson},
                                          {M::exact_xpbd, A::none},
                                          {M::mass_splitting, A::none},
                                          {M::mass_splitting, A::chebyshev},
                                          {M::mass_splitting, A::anderson_positions},
                                          {M::gauss_seidel, A::none},
                                          {M::gauss_seidel, A::chebyshev},
                                          {M::gauss_seidel, A::anderson_positions},
                                          {M::jacobi, A::none},
                                          {M::jacobi, A::chebyshev},
                                          {M::jacobi, A::anderson_positions}};
  return pairs;
}

std::vector<Pair> poster_pairs() {
  std::vector<Pair> pairs;
  for (const Pair& pair : legal_pairs()) {
    const bool method =
        pair.method == Method::jacobi || pair.method == Method::mass_splitting || pair.method == Method::gauss_seidel;
    if (method) pairs.push_back(pair);
  }
  return pairs;
}

const char* name_of(Method method) {
  switch (method) {
    case Method::jacobi:
      return "jacobi";
    case Method::mass_splitting:
      return "mass_splitting";
    case Method::gauss_seidel:
      return "gauss_seidel";
    case Method::exact_xpbd:
      return "exact_xpbd";
    case Method::vertex_descent:
      return "vertex_descent";
    case Method::two_level:
      return "two_level";
  }
  return "";
}

const char* name_of(Acceleration acceleration) {
  switch (acceleration) {
    case Acceleration::none:
      return "none";
    case Acceleration::chebyshev:
      return "chebyshev";
    case Acceleration::anderson_positions:
      return "anderson_positions";
    case Acceleration::anderson:
      return "anderson";
    case Acceleration::nonlinear_cg:
      return "nonlinear_cg";
    case Acceleration::subspace:
      return "subspace";
  }
  return "";
}

const char* label_of(Method method) {
  switch (method) {
    case Method::jacobi:
      return "Jacobi, averaged";
    case Method::mass_splitting:
      return "Jacobi, mass splitting";
    case Method::gauss_seidel:
      return "Gauss-Seidel, colored";
    case Method::exact_xpbd:
      return "XPBD, exact";
    case Method::vertex_descent:
      return "Vertex block descent";
    case Method::two_level:
      return "Two-level";
  }
  return "";
}

const char* label_of(Acceleration acceleration) {
  switch (acceleration) {
    case Acceleration::none:
      return "none";
    case Acceleration::chebyshev:
      return "Chebyshev";
    case Acceleration::anderson_positions:
      return "Anderson on positions";
    case Acceleration::anderson:
      return "Anderson";
    case Acceleration::nonlinear_cg:
      return "Conjugate gradients";
    case Acceleration::subspace:
      return "Subspace";
  }
  return "";
}

const char* help_of(Acceleration acceleration) {
  switch (acceleration) {
    case Acceleration::none:
      return "Every iteration as the method makes it; two_level still chooses the length of its step by the minimum of "
             "a quadratic model.";
    case Acceleration::chebyshev:
      return "Overshoots by weights that follow from the spectral radius of the iteration (Wang 2015): three "
             "dispatches, nearly free. Falls back to plain iterations when the residual grows. It moves the positions "
             "and not the multipliers: with many iterations the body gets stiffer than its material.";
    case Acceleration::anderson_positions:
      return "Combines the last iterations so that the change of positions gets smallest (Peng et al. 2018): the "
             "poster's. Its limitation: the multipliers are not combined, so the tissue's own compliance is lost: with "
             "many iterations the body gets stiffer than its material.";
    case Acceleration::anderson:
      return "Combines the last iterations so that the change of the whole state gets smallest: positions and, with "
             "XPBD methods, multipliers by the same weights, so the material keeps its stiffness. Memory and dot "
             "products grow with the window.";
    case Acceleration::nonlinear_cg:
      return "Steps along the correction and the last step at once, with the factors that minimise a quadratic model "
             "of the energy. Of a step that raises the energy only a part is kept.";
    case Acceleration::subspace:
      return "As conjugate gradients, but the fine and the coarse correction get a factor each: more robust for stiff, "
             "thin and mixed tissue and more exact in motion, at a slightly dearer iteration.";
  }
  return "";
}

bool applies(std::string_view setting, const Pair& pair) {
  if (setting == "colors") return pair.method == Method::gauss_seidel;
  if (setting == "spectral_radius") return pair.acceleration == Acceleration::chebyshev;
  if (setting == "window")
    return pair.acceleration == Acceleration::anderson_positions || pair.acceleration == Acceleration::anderson;
  return true;
}

const char* help_of(Method method) {
  switch (method) {
    case Method::jacobi:
      return "All tets at once, each vertex takes the mean of its tets' corrections: the poster's method. Always "
             "stable, but too soft: it does not converge to the material's stiffness, however many iterations it gets.";
    case Method::mass_splitting:
      return "All tets at once, each with its share of a vertex's mass. As cheap and stable as averaging, keeps "
             "momentum, and converges to within a few percent of the exact step; stiff tissue needs many iterations or "
             "substeps.";
    case Method::gauss_seidel:
      return "Color by color, each tet sees the corrections before it; one dispatch per color. Converges fastest on "
             "soft tissue with short steps. Stiff tissue with long steps makes it invert tets or diverge: use more "
             "substeps.";
    case Method::exact_xpbd:
      return "XPBD that converges to the exact step: the residual of the positions, which XPBD drops, is fed back, "
             "with masses raised by the tension around each vertex. About 1.4 times the cost of Jacobi. Few iterations "
             "on stiff tissue can add energy.";
    case Method::vertex_descent:
      return "Vertex by vertex, each minimises the energy around it (Chen et al. 2024), one dispatch per vertex color. "
             "Converges to the exact step, fast for short waves, ever more slowly for the bending of large meshes.";
    case Method::two_level:
      return "Every vertex's own block and a coarse space for the motion of large parts, with rotations kept up to "
             "date. Reaches the exact step in few iterations, however fine the mesh and however stiff the tissue.";
  }
  return "";
}

bool carries(Method method, MaterialModel model) {
  return law_of(model).of_strain || method == Method::two_level || method == Method::vertex_descent;
}

void require_carried(Method method, const std::vector<Material>& materials, const std::string& where) {
  for (const Material& material : materials) {
    if (carries(method, material.model)) continue;
    std::vector<std::string> able;
    for (const Pair& pair : legal_pairs())
      if (carries(pair.method, material.model) && (able.empty() || able.back() != name_of(pair.method)))
        able.push_back(name_of(pair.method));
    throw Error(where, std::string(name_of(method)) + " does not carry the material model " + name_of(material.model),
                "expected one of the methods that do: " + join(able));
  }
}

std::optional<Pair> find_pair(std::optional<std::string_view> method, std::optional<std::string_view> acceleration) {
  for (const Pair& pair : legal_pairs()) {
    if (method && *method != name_of(pair.method)) continue;
    if (acceleration && *acceleration != name_of(pair.acceleration)) continue;
    return pair;
  }
  return std::nullopt;
}

std::string list_of_pairs() {
  std::vector<std::string> pairs;
  for (const Pair& pair : legal_pairs()) {
    pairs.push_back(std::string(name_of(pair.method)) + " with " + name_of(pair.acceleration));
  }
  return join(pairs);
}

}  // namespace fascia
