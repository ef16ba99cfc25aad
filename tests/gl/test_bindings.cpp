#include "gl/bindings.h"

#include "gl/buffer.h"
#include "tests/gl/gl_support.h"

namespace fascia::gl {

TEST_CASE("a block has one binding point in all kernels, unless another block of the kernel has it") {
  const auto context = test::each_context();
  std::set<GLuint> first, second;
  const GLuint mass = binding_point("TestedMass", first), force = binding_point("TestedForce", first);
  CHECK(mass != force);
  CHECK(binding_point("TestedForce", second) == force);
  CHECK(binding_point("TestedMass", second) == mass);
  std::set<GLuint> taken{mass};
  const GLuint other = binding_point("TestedMass", taken);
  CHECK(other != mass);
  CHECK(taken == std::set<GLuint>{mass, other});
  // More blocks in one kernel than there are points are refused by the driver; up to that number all differ.
  std::set<GLuint> all;
  for (int i = 0; i < device().max_storage_bindings; ++i) binding_point("Tested" + std::to_string(i), all);
  CHECK(all.size() == static_cast<std::size_t>(device().max_storage_bindings));
  CHECK(*all.rbegin() < static_cast<GLuint>(device().max_storage_bindings));
}

TEST_CASE("a new block shares the binding point that was asked for least recently") {
  const auto context = test::each_context();
  const int points = device().max_storage_bindings;
  const auto point_of = [](const std::string& block) {
    std::set<GLuint> taken;
    return binding_point(block, taken);
  };
  const std::string stem = "Of_" + context->name() + "_";
  std::map<std::string, GLuint> filled;
  for (int i = 0; i < points; ++i) filled[stem + std::to_string(i)] = point_of(stem + std::to_string(i));
  const auto [idle, left] = *std::next(filled.begin(), points / 2);
  for (const auto& [block, point] : filled)
    if (block != idle) CHECK(point_of(block) == point);
  CHECK(point_of(stem + "Latecomer") == left);
}

TEST_CASE("a binding is made again only outside of a scope, or after its buffer has ended") {
  const auto context = test::each_context();
  Buffer a("a", 64), b("b", 64);
  const auto made = [](GLuint buffer) {
    const std::uint64_t before = binding_count();
    bind_storage(3, buffer);
    return binding_count() - before;
  };
  CHECK(made(a.id()) == 1);
  CHECK(made(a.id()) == 1);
  {
    const KeptBindings kept;
    CHECK(made(a.id()) == 1);
    CHECK(made(a.id()) == 0);
    CHECK(made(b.id()) == 1);
    CHECK(made(a.id()) == 1);
    const GLuint number = a.id();
    a = Buffer();
    CHECK(made(number) == 1);
  }
  const KeptBindings again;
  CHECK(made(b.id()) == 1);
}

}  // namespace fascia::gl
