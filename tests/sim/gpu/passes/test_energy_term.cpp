// The external energies in kernels: the sum of those that act, and no code for the others.
#include <catch2/catch.hpp>

#include <map>

#include "sim/gpu/passes/energy_term.h"

using namespace fascia;

namespace {

class Term : public EnergyTerm {
 public:
  Term(std::string name, std::vector<VertexStiffness> stiffness, bool blocks = false)
      : name_(std::move(name)), stiffness_(std::move(stiffness)), blocks_(blocks) {}
  std::string name() const override { return name_; }
  bool acts() const override { return !stiffness_.empty(); }
  bool has_blocks() const override { return blocks_; }
  std::optional<std::string> define(TermUse use) const override {
    if (!blocks_) return "1";
    return use == TermUse::gradient ? std::optional("1") : use == TermUse::block ? std::optional("2") : std::nullopt;
  }
  void bind(TermUse, gl::ComputePass::Bindings& bindings) const override { bindings.emplace_back(name_, nullptr); }
  std::vector<VertexStiffness> stiffness() const override { return stiffness_; }
  std::vector<gl::ComputePass> project(gl::ProgramCache&, const SimBuffers&, bool) const override { return {}; }
  std::vector<gl::ComputePass> impulses(gl::ProgramCache&, const SimBuffers&) const override { return {}; }

 private:
  std::string name_;
  std::vector<VertexStiffness> stiffness_;
  bool blocks_;
};

using Texts = std::map<std::string, std::string>;

Texts defines_of(const EnergyTerms& terms, TermUse use, gl::ComputePass::Bindings& bindings) {
  const gl::Defines list = with_energy_terms({{"OTHER", "2"}}, bindings, terms, use);
  return {list.begin(), list.end()};
}

const std::string kGradient = "EXTERNAL_GRADIENT(v, u, scale)", kStiffness = "EXTERNAL_STIFFNESS(v, scale)";

}  // namespace

TEST_CASE("kernels sum the external energies that act") {
  const Term first("first", {{3, 10}}), idle("idle", {}), second("second", {{3, 5}, {4, 7}});
  const EnergyTerms terms{&first, &idle, &second};
  const std::string gradients = "(first_gradient(v, u, scale) + second_gradient(v, u, scale))",
                    factors = "(first_stiffness(v, scale) + second_stiffness(v, scale))";
  const Texts common{{"OTHER", "2"}, {"FIRST", "1"}, {"IDLE", "0"}, {"SECOND", "1"}};
  for (const TermUse use : {TermUse::gradient, TermUse::stiffness, TermUse::block, TermUse::all}) {
    Texts expected = common;
    if (use == TermUse::gradient || use == TermUse::all) expected[kGradient] = gradients;
    if (use != TermUse::gradient) expected[kStiffness] = factors;
    gl::ComputePass::Bindings bindings;
    CHECK(defines_of(terms, use, bindings) == expected);
    REQUIRE(bindings.size() == 2);
    CHECK(std::string(bindings[0].first) == "first");
    CHECK(std::string(bindings[1].first) == "second");
  }
  CHECK(stiffness_of(terms) == std::vector<VertexStiffness>{{3, 10}, {3, 5}, {4, 7}});
}

TEST_CASE("a term whose stiffness depends on the direction has a block instead of a factor") {
  const Term factor("factor", {{3, 10}}), block("block", {{3, 5}}, true);
  const EnergyTerms terms{&factor, &block};
  gl::ComputePass::Bindings at_block, at_sum;
  CHECK(defines_of(terms, TermUse::block, at_block) == Texts{{"OTHER", "2"},
                                                             {"FACTOR", "1"},
                                                             {"BLOCK", "2"},
                                                             {kStiffness, "(factor_stiffness(v, scale))"},
                                                             {"EXTERNAL_BLOCK(v, scale)", "block_block_of(v, scale)"}});
  CHECK(at_block.size() == 2);
  CHECK(defines_of(terms, TermUse::stiffness, at_sum) ==
        Texts{{"OTHER", "2"}, {"FACTOR", "1"}, {"BLOCK", "0"}, {kStiffness, "(factor_stiffness(v, scale))"}});
  CHECK(at_sum.size() == 1);
}

TEST_CASE("kernels without external energies have no code and no buffer for them") {
  const Term idle("idle", {});
  for (const TermUse use : {TermUse::gradient, TermUse::stiffness, TermUse::block, TermUse::all}) {
    gl::ComputePass::Bindings bindings;
    CHECK(defines_of({&idle}, use, bindings) == Texts{{"OTHER", "2"}, {"IDLE", "0"}});
    CHECK(bindings.empty());
  }
  CHECK(stiffness_of({&idle}).empty());
}
