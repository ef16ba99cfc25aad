#include "sim/gpu/passes/energy_term.h"

#include <cctype>

namespace fascia {
namespace {

std::string sum_of(const std::string& sum, const std::string& summand) {
  return sum.empty() ? summand : sum + " + " + summand;
}

}  // namespace

gl::Defines with_energy_terms(gl::Defines defines, gl::ComputePass::Bindings& bindings, const EnergyTerms& terms) {
  std::string gradient, stiffness;
  for (const EnergyTerm* term : terms) {
    std::string capitals = term->name();
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    defines.emplace_back(capitals, term->acts() ? "1" : "0");
    if (!term->acts()) continue;
    term->bind(bindings);
    gradient = sum_of(gradient, term->name() + "_gradient(v, u, scale)");
    stiffness = sum_of(stiffness, term->name() + "_stiffness(v, scale)");
  }
  defines.emplace_back("EXTERNAL", gradient.empty() ? "0" : "1");
  if (gradient.empty()) return defines;
  defines.emplace_back("EXTERNAL_GRADIENT(v, u, scale)", "(" + gradient + ")");
  defines.emplace_back("EXTERNAL_STIFFNESS(v, scale)", "(" + stiffness + ")");
  return defines;
}

std::vector<VertexStiffness> stiffness_of(const EnergyTerms& terms) {
  std::vector<VertexStiffness> all;
  for (const EnergyTerm* term : terms)
    if (term->acts())
      for (const VertexStiffness& at_vertex : term->stiffness()) all.push_back(at_vertex);
  return all;
}

}  // namespace fascia
