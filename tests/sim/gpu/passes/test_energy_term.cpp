// The external energies in kernels: the sum of those that act, and no code for the others.
#include <catch2/catch.hpp>

#include <map>

#include "sim/gpu/passes/energy_term.h"

using namespace fascia;

namespace {

class Term : public EnergyTerm {
 public:
  Term(std::string name, std::vector<VertexStiffness> stiffness)
      : name_(std::move(name)), stiffness_(std::move(stiffness)) {}
  std::string name() const override { return name_; }
  bool acts() const override { return !stiffness_.empty(); }
  void bind(gl::ComputePass::Bindings& bindings) const override { bindings.emplace_back(name_, nullptr); }
  std::vector<VertexStiffness> stiffness() const override { return stiffness_; }
  std::vector<gl::ComputePass> project(gl::ProgramCache&, const SimBuffers&, bool) const override { return {}; }
  std::vector<gl::ComputePass> impulses(gl::ProgramCache&, const SimBuffers&) const override { return {}; }

 private:
  std::string name_;
  std::vector<VertexStiffness> stiffness_;
};

}  // namespace

TEST_CASE("kernels sum the external energies that act") {
  const Term first("first", {{3, 10}}), idle("idle", {}), second("second", {{3, 5}, {4, 7}});
  gl::ComputePass::Bindings bindings;
  const gl::Defines list = with_energy_terms({{"OTHER", "2"}}, bindings, {&first, &idle, &second});
  const std::map<std::string, std::string> defines(list.begin(), list.end());
  CHECK(defines ==
        std::map<std::string, std::string>{
            {"OTHER", "2"},
            {"FIRST", "1"},
            {"IDLE", "0"},
            {"SECOND", "1"},
            {"EXTERNAL", "1"},
            {"EXTERNAL_GRADIENT(v, u, scale)", "(first_gradient(v, u, scale) + second_gradient(v, u, scale))"},
            {"EXTERNAL_STIFFNESS(v, scale)", "(first_stiffness(v, scale) + second_stiffness(v, scale))"}});
  REQUIRE(bindings.size() == 2);
  CHECK(std::string(bindings[0].first) == "first");
  CHECK(std::string(bindings[1].first) == "second");
  CHECK(stiffness_of({&first, &idle, &second}) == std::vector<VertexStiffness>{{3, 10}, {3, 5}, {4, 7}});
}

TEST_CASE("kernels without external energies have no code and no buffer for them") {
  const Term idle("idle", {});
  gl::ComputePass::Bindings bindings;
  const gl::Defines list = with_energy_terms({}, bindings, {&idle});
  CHECK(std::map<std::string, std::string>(list.begin(), list.end()) ==
        std::map<std::string, std::string>{{"EXTERNAL", "0"}, {"IDLE", "0"}});
  CHECK(bindings.empty());
  CHECK(stiffness_of({&idle}).empty());
}
