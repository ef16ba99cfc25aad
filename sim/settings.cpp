#include "sim/settings.h"

#include "sim/suggest.h"

namespace fascia {

const std::vector<Pair>& legal_pairs() {
  static const std::vector<Pair> pairs = [] {
    std::vector<Pair> all;
    for (const Method method : {Method::mass_splitting, Method::gauss_seidel, Method::jacobi})
      for (const Acceleration acceleration : {Acceleration::none, Acceleration::chebyshev, Acceleration::anderson_positions})
        all.push_back({method, acceleration});
    return all;
  }();
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
  }
  return "";
}

const char* help_of(Acceleration acceleration) {
  switch (acceleration) {
    case Acceleration::none:
      return "Every iteration as the method makes it.";
    case Acceleration::chebyshev:
      return "Overshoots by weights that follow from the spectral radius of the iteration (Wang 2015): three dispatches, nearly free. "
             "Falls back to plain iterations when the residual grows. It moves the positions and not the multipliers: with many "
             "iterations the body gets stiffer than its material.";
    case Acceleration::anderson_positions:
      return "Combines the last iterations so that the change of positions gets smallest (Peng et al. 2018): the poster's. "
             "Its limitation: the multipliers are not combined, so the tissue's own compliance is lost: with many iterations "
             "the body gets stiffer than its material.";
  }
  return "";
}

bool applies(std::string_view setting, const Pair& pair) {
  if (setting == "colors") return pair.method == Method::gauss_seidel;
  if (setting == "spectral_radius") return pair.acceleration == Acceleration::chebyshev;
  if (setting == "window") return pair.acceleration == Acceleration::anderson_positions;
  return true;
}

const char* help_of(Method method) {
  switch (method) {
    case Method::jacobi:
      return "All tets at once, each vertex takes the mean of its tets' corrections: the poster's method. Always stable, but too "
             "soft: it does not converge to the material's stiffness, however many iterations it gets.";
    case Method::mass_splitting:
      return "All tets at once, each with its share of a vertex's mass. As cheap and stable as averaging, keeps momentum, and "
             "converges to within a few percent of the exact step; stiff tissue needs many iterations or substeps.";
    case Method::gauss_seidel:
      return "Color by color, each tet sees the corrections before it; one dispatch per color. Converges fastest on soft "
             "tissue with short steps. Stiff tissue with long steps makes it invert tets or diverge: use more substeps.";
  }
  return "";
}

std::optional<Pair> find_pair(std::optional<std::string_view> method,
                              std::optional<std::string_view> acceleration) {
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
