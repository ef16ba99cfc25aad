// Passes that are fused into one dispatch do what they do one after another.
// Covers: fused_source
#include "gl/fused_pass.h"

#include <cstdlib>
#include <cstring>
#include <optional>

#include "tests/gl/gl_support.h"

namespace fascia::gl {
namespace {

using Catch::Matchers::Contains;

// Both kernels use the same names for different things.
constexpr const char* kSpread = R"(#include "common/io.glsl"
#define WEIGHT 0.5
INPUT_VEC4(Value, value)
OUTPUT(vec4, Result, result)
COMPUTE_1D
uniform uint count, distance, start;
struct SolverChoice {
  vec4 near, far;
};
SolverChoice load(uint i) { return SolverChoice(FETCH(value, i), FETCH(value, (i + start + distance) % count)); }
void main() {
  ITEM_OR_RETURN(i)
  SolverChoice pair = load(i);
  result[i] = WEIGHT * pair.near + (1.0 - WEIGHT) * pair.far;
}
)";
constexpr const char* kTurn = R"(#include "common/io.glsl"
#define WEIGHT 0.25
INPUT_VEC4(Result, result)
INPUT_VEC4_IN_PLACE(Before, before)
OUTPUT(vec4, Value, value)
COMPUTE_1D
uniform uint rounds;
struct SolverChoice {
  vec4 sum;
};
vec4 load(uint i) { return FETCH(result, i).yzxw; }
void main() {
  ITEM_OR_RETURN(i)
  SolverChoice pair = SolverChoice(load(i));
  for (uint k = 0u; k < rounds; ++k) pair.sum = vec4(1.0) - WEIGHT * pair.sum;
  vec4 v = FETCH(before, i) - pair.sum;
  value[i] = v - 2.0 * floor(0.5 * v + 0.5);  // from -1 to 1, so that lists are never all or nothing
}
)";
// Lists the items whose first component is larger than a bound, and processes the list.
constexpr const char* kListed = R"(#include "common/io.glsl"
INPUT_VEC4_IN_PLACE(Before, before)
OUTPUT(vec4, Value, value)
COMPUTE_1D
uniform uint bound;
void main() {
  ITEM_OR_RETURN(i)
  vec4 v = FETCH(before, i);
#ifdef DEFERS
  if (v.x > float(bound)) {
    defer(i);
    return;
  }
  value[i] = v + vec4(0.125);
#else
  value[i] = v * 0.5;
#endif
}
)";

class Folder : public test::ShaderFolder {
 public:
  Folder() {
    for (const char* name : {"common/fused.glsl", "common/fill.comp", "common/step.glsl"})
      std::filesystem::copy(test::source_dir() / "shaders" / name, path() / name);
    write("spread.comp", kSpread);
    write("turn.comp", kTurn);
    write("listed.comp", kListed);
  }
};

struct Values {
  static constexpr std::uint32_t kCount = 1000, kLists = 3;
  std::uint32_t some = 700;  // a variable that passes follow
  Buffer value, result{"result", 16 * kCount}, lists{"lists", 4 * kLists*(4 + kCount)};
  Buffer none{"none", std::vector<std::uint32_t>{0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0}};

  Values() {
    std::vector<float> start;
    for (std::uint32_t i = 0; i < 4 * kCount; ++i)
      start.push_back(static_cast<float>((i * 2654435761u) >> 12) / 524288.0f - 1.0f);
    value = Buffer("value", start);
  }
  // Ten passes, some with the same kernel, with `rounds` iterations in the loops of two.
  std::vector<ComputePass> passes(ProgramCache& programs, std::uint32_t rounds) {
    std::vector<ComputePass> passes;
    const auto spread = [&](ComputePass::Constants constants) {
      constants.emplace_back("count", kCount);
      passes
          .emplace_back(programs.compute("spread.comp"), ComputePass::Bindings{{"value", &value}, {"result", &result}},
                        kCount, std::move(constants))
          .loops(0);
      passes
          .emplace_back(programs.compute("turn.comp"),
                        ComputePass::Bindings{{"result", &result}, {"before", &value}, {"value", &value}}, kCount,
                        ComputePass::Constants{{"rounds", rounds}})
          .loops(rounds);
    };
    spread({{"distance", 1}, {"start", 3}});
    spread({{"distance", 17}});
    passes[2].follow("start", some);  // otherwise a constant
    passes.back().follow("invocations", some);
    for (std::uint32_t list = 0; list < kLists; ++list) {
      const bool stays_empty = list == 1;
      const ComputePass::Constants constants{{"deferred_list", 4 * list},
                                             {"deferred_begin", 4 * kLists + list * kCount},
                                             {"bound", stays_empty ? 1000u : 0u}};
      passes
          .emplace_back(programs.compute("listed.comp", {{"DEFERS", "1"}}),
                        ComputePass::Bindings{{"before", &value}, {"value", &value}, {"deferred", &lists}}, kCount,
                        constants)
          .loops(0);
      if (list == 0) passes.back().copy_first(none, lists);
      passes
          .emplace_back(programs.compute("listed.comp", {{"DEFERRED", "1"}}),
                        ComputePass::Bindings{{"before", &value}, {"value", &value}, {"deferred_items", &lists}},
                        kCount, constants)
          .loops(0);
      passes.back().set_indirect(lists, 4 * list);
    }
    return passes;
  }
};

std::vector<float> run_alone(const Folder& folder, std::uint32_t rounds, std::uint32_t repeats) {
  ProgramCache programs(folder.path(), LoadPath::texel);
  Values values;
  const std::vector<ComputePass> passes = values.passes(programs, rounds);
  for (std::uint32_t r = 0; r < repeats; ++r) {
    if (r == 2) values.some = 900;
    for (const ComputePass& pass : passes) pass.run();
  }
  return values.value.read<float>();
}

// Sets the number of members that fused passes expect. The device's threads are unchanged.
class Members {
 public:
  explicit Members(const char* count) {
    if (const char* before = std::getenv("LP_NUM_THREADS")) before_ = before;
    setenv("LP_NUM_THREADS", count, 1);
  }
  ~Members() { before_ ? setenv("LP_NUM_THREADS", before_->c_str(), 1) : unsetenv("LP_NUM_THREADS"); }
  Members(const Members&) = delete;
  Members& operator=(const Members&) = delete;

 private:
  std::optional<std::string> before_;
};

std::size_t differences(const std::vector<float>& a, const std::vector<float>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += std::memcmp(&a[i], &b[i], sizeof(float)) != 0;
  return count;
}

}  // namespace

TEST_CASE("fused passes compute the same as separate ones, in one dispatch", "[threads]") {
  const auto context = test::each_context();
  if (!test::fuses_here()) return;
  Folder folder;
  constexpr std::uint32_t kRuns = 60;  // late groups arrive at a different time in each run
  const std::vector<float> expected = run_alone(folder, 3, 2 + 3 * kRuns);
  ProgramCache programs(folder.path(), LoadPath::texel);
  Values values;
  std::vector<ComputePass> passes;
  {
    const ProgramCache::Postponed postponed(programs);
    passes = values.passes(programs, 3);
  }
  CHECK(programs.size() == 0);
  const FusedPasses fused(programs, passes);
  CHECK(programs.size() == 1);  // they need no programs of their own
  CHECK(fused.dispatches(1) == 1);
  CHECK(fused.dispatches(3) == 1);
  const std::uint64_t before = dispatch_count();
  fused.run(2);
  values.some = 900;
  for (std::uint32_t i = 0; i < kRuns; ++i) fused.run(3);
  CHECK(dispatch_count() >= before + 1 + kRuns);  // more if a group waited too long
  const std::vector<float> found = values.value.read<float>();
  CAPTURE(differences(found, expected), found[0], expected[0]);
  CHECK(differences(found, expected) == 0);
  const std::vector<std::uint32_t> lists = values.lists.read<std::uint32_t>();
  CAPTURE(lists[3], lists[7], lists[11]);
  CHECK((lists[3] > 0 && lists[7] == 0 && lists[11] > 0));
  CHECK(GetError() == GL_NO_ERROR);

  CHECK(programs.reload().empty());
  fused.run();
  CHECK(differences(values.value.read<float>(), found) > 0);
}

TEST_CASE("work that exceeds the loops of one dispatch is done in several", "[threads]") {
  const auto context = test::each_context();
  if (!test::fuses_here()) return;
  Folder folder;
  // Iterations in the loops of 250 work groups per repeat; llvmpipe permits 65,535 to each member
  constexpr std::uint32_t kRounds = 1500;
  const std::vector<float> expected = run_alone(folder, kRounds, 4);
  ProgramCache programs(folder.path(), LoadPath::texel);
  Values values;
  const FusedPasses fused(programs, values.passes(programs, kRounds));
  const std::uint64_t before = dispatch_count();
  fused.run(2);
  values.some = 900;
  fused.run(2);
  const std::uint64_t dispatches = dispatch_count() - before;
  const std::vector<float> found = values.value.read<float>();
  CAPTURE(dispatches, differences(found, expected), found[0], expected[0]);
  CHECK(dispatches > 2);
  CHECK(differences(found, expected) == 0);
}

TEST_CASE("every work group runs once, for any number of members", "[threads]") {
  const auto context = test::each_context();
  if (!test::fuses_here()) return;
  Folder folder;
  folder.write(
      "more.comp",
      "#include \"common/io.glsl\"\nINPUT_VEC4_IN_PLACE(Before, before)\nOUTPUT(vec4, Value, "
      "value)\nCOMPUTE_1D\nuniform uint step;\n"
      "void main() {\n  ITEM_OR_RETURN(i)\n  value[i] = FETCH(before, i) + vec4(float(step), 1.0, 0.0, 0.0);\n}\n");
  const char* crew = GENERATE("1", "2", "3", "4", "5", "7", "16");
  const std::uint32_t count = GENERATE(1u, 37u, 1000u, 200'001u);  // the last one in units of several work groups
  const Members members(crew);
  ProgramCache programs(folder.path(), LoadPath::texel);
  const Buffer value("value", std::vector<float>(4 * std::size_t{count}, 0.0f));
  std::vector<ComputePass> passes;
  for (const std::uint32_t step : {1u, 10u, 100u})
    passes
        .emplace_back(programs.compute("more.comp"), ComputePass::Bindings{{"before", &value}, {"value", &value}},
                      count, ComputePass::Constants{{"step", step}})
        .loops(0);
  const FusedPasses fused(programs, passes);
  constexpr std::uint32_t kRepeats = 5;
  fused.run(kRepeats);
  const std::vector<float> found = value.read<float>();
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < found.size(); i += 4)
    wrong += found[i] != 111.0f * kRepeats || found[i + 1] != 3.0f * kRepeats;
  CAPTURE(crew, count, found[0], found[1], wrong);
  CHECK(wrong == 0);
}

TEST_CASE("a pass without a stated number of loops, and a single one, are dispatched separately") {
  const auto context = test::each_context();
  if (!test::fuses_here()) return;
  Folder folder;
  ProgramCache programs(folder.path(), LoadPath::texel);
  Values values;
  std::vector<ComputePass> passes = values.passes(programs, 3);
  passes[1] = ComputePass(programs.compute("turn.comp"),
                          {{"result", &values.result}, {"before", &values.value}, {"value", &values.value}},
                          Values::kCount, {{"rounds", 3}});
  const FusedPasses fused(programs, passes);
  CHECK(fused.dispatches(1) == 3);  // one, one, and the other eight
  CHECK(fused.dispatches(5) == 15);
  const std::uint64_t before = dispatch_count();
  fused.run(5);
  CHECK(dispatch_count() == before + 15);

  const std::vector<float> found = values.value.read<float>();
  Values again;
  const std::vector<ComputePass> alone = again.passes(programs, 3);
  for (int r = 0; r < 5; ++r)
    for (const ComputePass& pass : alone) pass.run();
  const std::vector<float> expected = again.value.read<float>();
  CAPTURE(differences(found, expected));
  CHECK(differences(found, expected) == 0);
  CHECK(FusedPasses(programs, {}).dispatches(1) == 0);
}

TEST_CASE("errors in a fused kernel are reported with file and line") {
  const auto context = test::each_context();
  if (!test::fuses_here()) return;
  Folder folder;
  folder.write(
      "wrong.comp",
      "#include \"common/io.glsl\"\nOUTPUT(vec4, Value, value)\nCOMPUTE_1D\nvoid main() {\n  ITEM_OR_RETURN(i)\n"
      "  value[i] = nothing;\n}\n");
  ProgramCache programs(folder.path(), LoadPath::texel);
  Values values;
  std::vector<ComputePass> passes = values.passes(programs, 3);
  {
    const ProgramCache::Postponed postponed(programs);
    passes.emplace_back(programs.compute("wrong.comp"), ComputePass::Bindings{{"value", &values.value}}, Values::kCount)
        .loops(0);
  }
  const std::string message = test::error_of([&] { FusedPasses(programs, passes); });
  CHECK_THAT(message, Contains("shaders/wrong.comp:6") && Contains("nothing") &&
                          Contains("fused spread, turn, spread, fill, listed, listed, wrong"));
}

TEST_CASE("passes are fused on request, if inputs are texels of a software renderer") {
  const auto context = test::each_context();
  if (!test::fuses_here()) return;
  Folder folder;
  ProgramCache texels(folder.path(), LoadPath::texel), storage(folder.path(), LoadPath::storage);
  CAPTURE(device().renderer, device().vector_width);
  CHECK_FALSE(fuses(texels));
  texels.set_fusing(true);
  storage.set_fusing(true);
  CHECK(fuses(texels));
  CHECK_FALSE(fuses(storage));
}

}  // namespace fascia::gl
