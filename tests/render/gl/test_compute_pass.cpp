#include <catch2/catch.hpp>

#include <cstring>

#include "render/context.h"
#include "render/gl/compute_pass.h"
#include "sim/error.h"
#include "tests/render/gl/shader_folder.h"

namespace fascia::gl {
namespace {

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
  static constexpr std::size_t kCount = 130;  // two full groups and a bit
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
    // One group more than is written, to see that the guard works.
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
  const auto context = test::make_test_context(GENERATE(as<std::string>(), "osmesa", "egl"));
  CAPTURE(context->name());
  ShaderFolder folder;
  folder.write("scale.comp", kScale);
  const std::vector<float> storage = run_scale(folder, LoadPath::storage);
  const std::vector<float> texel = run_scale(folder, LoadPath::texel);
  REQUIRE(storage.size() == texel.size());
  CHECK(std::memcmp(storage.data(), texel.data(), storage.size() * sizeof(float)) == 0);
  for (std::size_t i = 0; i < Inputs::kCount; i += 43) {
    const float p = static_cast<float>(Inputs::kCount - 1 - i) * 0.37f + 1 / 7.0f;
    CAPTURE(i);
    CHECK(storage[4 * i + 1] ==
          Approx(2.5f * p / static_cast<float>(i + 3) + static_cast<float>(4 * i + 1)).epsilon(1e-6));
  }
}

}  // namespace fascia::gl
