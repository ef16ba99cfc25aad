#include "sim/settings.h"

#include "sim/suggest.h"

namespace fascia {

const std::vector<Pair>& legal_pairs() {
  static const std::vector<Pair> pairs = {{Method::gauss_seidel, Acceleration::none},
                                           {Method::jacobi, Acceleration::none}};
  return pairs;
}

const char* name_of(Method method) {
  switch (method) {
    case Method::jacobi:
      return "jacobi";
    case Method::gauss_seidel:
      return "gauss_seidel";
  }
  return "";
}

const char* name_of(Acceleration acceleration) {
  switch (acceleration) {
    case Acceleration::none:
      return "none";
  }
  return "";
}

const char* label_of(Method method) {
  switch (method) {
    case Method::jacobi:
      return "Jacobi XPBD, averaged";
    case Method::gauss_seidel:
      return "Gauss-Seidel XPBD, colored";
  }
  return "";
}

const char* help_of(Method method) {
  switch (method) {
    case Method::jacobi:
      return "All tets at once, each vertex takes the mean of its tets' corrections. The cheapest iteration "
             "and always "
             "stable, but too soft: it does not converge to the material's stiffness, however many "
             "iterations it gets.";
    case Method::gauss_seidel:
      return "Color by color, each tet sees the corrections before it. One dispatch per color, a few percent "
             "off the exact step; more substeps make it exact. Very stiff tissue (1e7 Pa) with long steps can "
             "invert tets.";
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
