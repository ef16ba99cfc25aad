#include "sim/gpu/passes/energy_term.h"

#include <cctype>

namespace fascia {
namespace {

std::string sum_of(const std::string& sum, const std::string& summand) {
  return sum.empty() ? summand : sum + " + " + summand;
}

}  // namespace

gl::Defines with_energy_terms(gl::Defines defines, gl::ComputePass::Bindings& bindings, const EnergyTerms& terms,
                              TermUse use) {
  std::string gradient, stiffness, block;
  for (const EnergyTerm* term : terms) {
    const std::optional<std::string> define = term->acts() ? term->define(use) : std::nullopt;
    std::string capitals = term->name();
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    defines.emplace_back(capitals, define.value_or("0"));
    if (!define) continue;
    term->bind(use, bindings);
    if (use == TermUse::gradient || use == TermUse::all)
      gradient = sum_of(gradient, term->name() + "_gradient(v, u, scale)");
    if (use != TermUse::gradient && !term->has_blocks())
      stiffness = sum_of(stiffness, term->name() + "_stiffness(v, scale)");
    if (use == TermUse::block && term->has_blocks()) block = term->name() + "_block_of(v, scale)";
  }
  if (!gradient.empty()) defines.emplace_back("EXTERNAL_GRADIENT(v, u, scale)", "(" + gradient + ")");
  if (!stiffness.empty()) defines.emplace_back("EXTERNAL_STIFFNESS(v, scale)", "(" + stiffness + ")");
  if (!block.empty()) defines.emplace_back("EXTERNAL_BLOCK(v, scale)", block);
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
