#include "gl/compute_pass.h"

#include <cstring>

#include "tests/gl/gl_support.h"

namespace fascia::gl {
namespace {

using Catch::Matchers::Contains;
using test::error_of;
using test::ShaderFolder;

constexpr const char* kScale = R"(#include "common/io.glsl"
INPUT_VEC4(Position, position)
INPUT_FLOAT(Weight, weight)
INPUT_UINT(SlotBegin, slot_begin)
INPUT_UVEC4(Corner, corner)
OUTPUT(vec4, Result, result)
INOUT(uint, Visit, visit)
COMPUTE_1D
uniform float scale;
void main() {
  ITEM_OR_RETURN(i)
  uvec4 c = FETCH(corner, i);
  result[i] = scale * FETCH1(weight, i) * FETCH(position, FETCH1(slot_begin, i)) + vec4(c);
  visit[i] += 1u;
}
)";

struct Inputs {
  static constexpr std::size_t kCount = 130;  // two full groups and a remainder
  Buffer position, weight, slot_begin, corner, result, visit;

  Inputs() {
    std::vector<float> p(4 * kCount), w(kCount);
    std::vector<std::uint32_t> s(kCount), c(4 * kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
      w[i] = 1.0f / static_cast<float>(i + 3);
      s[i] = static_cast<std::uint32_t>(kCount - 1 - i);
      for (std::size_t k = 0; k < 4; ++k) {
        p[4 * i + k] = static_cast<float>(i) * 0.37f + static_cast<float>(k) / 7.0f;
        c[4 * i + k] = static_cast<std::uint32_t>(i * 4 + k);
      }
    }
    position = Buffer("position", p);
    weight = Buffer("weight", w);
    slot_begin = Buffer("slot_begin", s);
    corner = Buffer("corner", c);
    // One group more than is written, to check the guard.
    result = Buffer("result", 16 * (kCount + 64));
    visit = Buffer("visit", 4 * (kCount + 64));
  }
  ComputePass::Bindings bindings() const {
    return {{"position", &position}, {"weight", &weight}, {"slot_begin", &slot_begin},
            {"corner", &corner},     {"result", &result}, {"visit", &visit}};
  }
};

std::vector<float> run_scale(const ShaderFolder& folder, LoadPath path) {
  ProgramCache programs(folder.path(), path);
  const Program& program = programs.compute("scale.comp");
  Inputs in;
  program.set("scale", 2.5f);
  const ComputePass pass(program, in.bindings(), Inputs::kCount);
  pass.run();
  pass.run();
  const std::vector<std::uint32_t> visits = in.visit.read<std::uint32_t>();
  for (std::size_t i = 0; i < visits.size(); ++i) {
    CAPTURE(i);
    REQUIRE(visits[i] == (i < Inputs::kCount ? 2u : 0u));
  }
  return in.result.read<float>();
}

}  // namespace

TEST_CASE("a kernel gives equal bits through both load paths") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write("scale.comp", kScale);
  const std::vector<float> storage = run_scale(folder, LoadPath::storage);
  const std::vector<float> texel = run_scale(folder, LoadPath::texel);
  REQUIRE(storage.size() == texel.size());
  CHECK(std::memcmp(storage.data(), texel.data(), storage.size() * sizeof(float)) == 0);
  for (std::size_t i = 0; i < Inputs::kCount; i += 43) {
    const float p = static_cast<float>(Inputs::kCount - 1 - i) * 0.37f + 1 / 7.0f;
    const float expected = 2.5f * p / static_cast<float>(i + 3) + static_cast<float>(4 * i + 1);
    CAPTURE(i);
    CHECK(storage[4 * i + 1] == Approx(expected).epsilon(1e-6));  // a few roundings of 6e-8
  }
  CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("a FirstRuns callback is called for each kernel before its first run, also for postponed and reloaded ones") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write("scale.comp", kScale);
  ProgramCache programs(folder.path(), LoadPath::texel);
  Inputs in;
  const ComputePass before(programs.compute("scale.comp", {{"VARIANT", "0"}}), in.bindings(), Inputs::kCount);
  before.run();  // no callback is set yet
  const auto pass_of = [&](const char* variant) {
    const ProgramCache::Postponed postponed(programs);
    return ComputePass(programs.compute("scale.comp", {{"VARIANT", variant}}), in.bindings(), Inputs::kCount);
  };
  const ComputePass one = pass_of("1"), same = pass_of("1"), other = pass_of("2");
  std::vector<std::size_t> linked;
  {
    const ProgramCache::FirstRuns first_runs(programs, [&] { linked.push_back(programs.size()); });
    before.run();
    CHECK(linked.empty());
    for (const ComputePass* pass : {&one, &one, &same, &other, &one}) pass->run();
    CHECK(linked == std::vector<std::size_t>{1, 2});  // called before a postponed program is linked
    CHECK(programs.reload().empty());
    for (const ComputePass* pass : {&one, &same, &before, &before}) pass->run();
    CHECK(linked == std::vector<std::size_t>{1, 2, 3, 3});
  }
  other.run();
  CHECK(linked.size() == 4);
}

TEST_CASE("bindings that do not fit the kernel are errors that name it") {
  const auto context = test::each_context();
  const LoadPath path = GENERATE(LoadPath::storage, LoadPath::texel);
  ShaderFolder folder;
  folder.write("scale.comp", kScale);
  ProgramCache programs(folder.path(), path);
  const Program& program = programs.compute("scale.comp", {{"VARIANT", "3"}});
  const Inputs in;
  const auto message = [&](const ComputePass::Bindings& bindings, std::uint32_t invocations = 1) {
    return error_of([&] { ComputePass(program, bindings, invocations); });
  };
  const Buffer spare("spare", 64), never_made;

  ComputePass::Bindings bindings = in.bindings();
  bindings.erase(bindings.begin() + 1);
  CHECK_THAT(message(bindings), Contains("kernel scale.comp [VARIANT=3]: ") && Contains("eight has no buffer"));
  bindings = in.bindings();
  bindings.erase(bindings.begin() + 4);
  CHECK_THAT(message(bindings), Contains("Result has no buffer"));
  bindings = in.bindings();
  bindings.emplace_back("spare", &spare);
  CHECK_THAT(message(bindings), Contains("has no buffer named spare"));
  bindings = in.bindings();
  bindings[0].second = &never_made;
  CHECK_THAT(message(bindings), Contains("the buffer for position was never made"));
  bindings[0].second = nullptr;
  CHECK_THAT(message(bindings), Contains("the buffer for position was never made"));
  bindings = in.bindings();
  bindings[4].second = &in.position;
  CHECK_THAT(message(bindings), Contains("position and result are one buffer"));
  bindings = in.bindings();
  bindings.emplace_back("weight", &spare);
  CHECK_THAT(message(bindings), Contains("weight is bound twice"));
  if (device().max_compute_groups < 0x7fffffff / 64)
    CHECK_THAT(message(in.bindings(), 0xffffffffu), Contains("67108864 work groups; expected at most"));
}

TEST_CASE("a declared input that the kernel does not use may be bound") {
  const auto context = test::each_context();
  const LoadPath path = GENERATE(LoadPath::storage, LoadPath::texel);
  ShaderFolder folder;
  folder.write("unused.comp",
               "#include \"common/io.glsl\"\nINPUT_FLOAT(Weight, weight)\nOUTPUT(uint, Visit, visit)\nCOMPUTE_1D\n"
               "void main() {\n  ITEM_OR_RETURN(i)\n  visit[i] = i + 1u;\n}\n");
  ProgramCache programs(folder.path(), path);
  const Buffer weight("weight", 64), visit("visit", 8);
  ComputePass(programs.compute("unused.comp"), {{"weight", &weight}, {"visit", &visit}}, 2).run();
  CHECK(visit.read<std::uint32_t>() == std::vector<std::uint32_t>{1, 2});
}

TEST_CASE("a uniform block is also bound by its name") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write("block.comp",
               "#include \"common/io.glsl\"\nlayout(std140) uniform StepValues { vec4 gravity; };\n"
               "OUTPUT(vec4, Result, result)\nCOMPUTE_1D\n"
               "void main() {\n  ITEM_OR_RETURN(i)\n  result[i] = 2.0 * gravity;\n}\n");
  ProgramCache programs(folder.path(), LoadPath::texel);
  const Buffer values("step values", std::vector<float>{0, -9.81f, 1, 2}), result("result", 16);
  ComputePass(programs.compute("block.comp"), {{"step_values", &values}, {"result", &result}}, 1).run();
  CHECK(result.read<float>() == std::vector<float>{0, -19.62f, 2, 4});
}

TEST_CASE("dispatches are counted, and empty ones are not made") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write("scale.comp", kScale);
  ProgramCache programs(folder.path(), LoadPath::texel);
  const Program& program = programs.compute("scale.comp");
  const Inputs in;
  const std::uint64_t before = dispatch_count();
  ComputePass(program, in.bindings(), 0).run();
  CHECK(dispatch_count() == before);
  const ComputePass pass(program, in.bindings(), 64);
  pass.run();
  pass.run();
  CHECK(dispatch_count() == before + 2);
  CHECK(in.visit.read<std::uint32_t>()[63] == 2);
  CHECK(in.visit.read<std::uint32_t>()[64] == 0);
}

TEST_CASE("the last work group sees what all groups have stored, in every dispatch", "[threads]") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write(
      "last.comp",
      "#include \"common/io.glsl\"\nCOHERENT(uint, Part, part)\nINOUT(uint, Sum, sum)\nuniform uint run;\nCOMPUTE_1D\n"
      "#include \"common/last_group.glsl\"\n"
      "void main() {\n"
      "  if (gl_LocalInvocationID.x == 0u) part[gl_WorkGroupID.x] = gl_WorkGroupID.x + run;\n"
      "  if (!is_last_group() || gl_LocalInvocationID.x > 0u) return;\n"
      "  uint all = 0u;\n"
      "  for (uint g = 0u; g < gl_NumWorkGroups.x; ++g) all += part[g];\n"
      "  sum[0] = all;\n  sum[1] += 1u;\n}\n");
  ProgramCache programs(folder.path(), LoadPath::storage);
  constexpr std::uint32_t kGroups = 1000, kRuns = 100;
  const Buffer part("part", 4 * kGroups), sum("sum", 8), arrivals("arrivals", 4);
  std::uint32_t run = 0;
  ComputePass pass(programs.compute("last.comp"), {{"part", &part}, {"sum", &sum}, {"arrivals", &arrivals}},
                   64 * kGroups, {{"run", 0}});
  pass.follow("run", run);
  for (run = 1; run <= kRuns; ++run) {
    pass.run();
    CAPTURE(run);
    REQUIRE(sum.read<std::uint32_t>() == std::vector<std::uint32_t>{kGroups * (kGroups - 1) / 2 + kGroups * run, run});
    REQUIRE(arrivals.read<std::uint32_t>() == std::vector<std::uint32_t>{0});
  }
}

TEST_CASE("the group size of a variant decides the number of groups") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write("scale.comp", kScale);
  ProgramCache programs(folder.path(), LoadPath::storage);
  const Inputs in;
  ComputePass(programs.compute("scale.comp", {{"GROUP_SIZE", "32"}}), in.bindings(), Inputs::kCount).run();
  const std::vector<std::uint32_t> visits = in.visit.read<std::uint32_t>();
  CHECK(std::count(visits.begin(), visits.end(), 1u) == Inputs::kCount);
}

TEST_CASE("passes of one program keep their own buffers") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write("add.comp",
               "#include \"common/io.glsl\"\nINPUT_UINT(From, from)\nINOUT(uint, To, to)\nCOMPUTE_1D\n"
               "void main() {\n  ITEM_OR_RETURN(i)\n  to[i] += FETCH1(from, i);\n}\n");
  ProgramCache programs(folder.path(), GENERATE(LoadPath::storage, LoadPath::texel));
  const Program& program = programs.compute("add.comp");
  const Buffer a("a", std::vector<std::uint32_t>{1}), b("b", std::vector<std::uint32_t>{10});
  const Buffer c("c", std::vector<std::uint32_t>{100});
  const ComputePass ab(program, {{"from", &a}, {"to", &b}}, 1), bc(program, {{"to", &c}, {"from", &b}}, 1);
  ab.run();
  bc.run();  // reads the output of the earlier pass
  ab.run();
  bc.run();
  CHECK(b.read<std::uint32_t>()[0] == 12);
  CHECK(c.read<std::uint32_t>()[0] == 100 + 11 + 12);
}

}  // namespace fascia::gl
