// Small passes over a few buffers: which barriers they make, and in front of what.
#include "gl/barriers.h"

#include "gl/compute_pass.h"
#include "tests/gl/gl_support.h"
#include "tests/support/gpu/swapped.h"

namespace fascia::gl {
namespace {

using test::ShaderFolder;

constexpr GLbitfield kStorage = GL_SHADER_STORAGE_BARRIER_BIT, kTexel = GL_TEXTURE_FETCH_BARRIER_BIT,
                     kUpdate = GL_BUFFER_UPDATE_BARRIER_BIT, kCommand = GL_COMMAND_BARRIER_BIT,
                     kVertices = GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT;

constexpr const char* kCopy = R"(#include "common/io.glsl"
INPUT_UINT(Source, source)
OUTPUT(uint, Target, target)
COMPUTE_1D
void main() {
  ITEM_OR_RETURN(i)
  target[i] = FETCH1(source, i) + 1u;
}
)";

std::vector<GLbitfield> made;
decltype(MemoryBarrier) make;

/// The bits of each barrier that `action` makes.
template <class Action>
std::vector<GLbitfield> barriers_of(Action action) {
  made.clear();
  make = MemoryBarrier;
  const test::Swapped swapped(
      MemoryBarrier, +[](GLbitfield bits) {
        made.push_back(bits);
        make(bits);
      });
  action();
  return made;
}

using Bits = std::vector<GLbitfield>;

}  // namespace

TEST_CASE("barriers are made where stores are read or passed over, and nowhere else") {
  const auto context = test::each_context();
  const LoadPath path = GENERATE(LoadPath::storage, LoadPath::texel);
  const GLbitfield reads = path == LoadPath::storage ? kStorage : kTexel;
  ShaderFolder folder;
  folder.write("copy.comp", kCopy);
  ProgramCache programs(folder.path(), path);
  const Program& copy = programs.compute("copy.comp");
  const std::vector<std::uint32_t> ones(64, 1);
  Buffer a("a", ones), b("b", ones), c("c", ones);
  const auto pass = [&](const Buffer& from, const Buffer& to) {
    return ComputePass(copy, {{"source", &from}, {"target", &to}}, 64);
  };
  const ComputePass a_to_b = pass(a, b), a_to_c = pass(a, c), b_to_c = pass(b, c), c_to_a = pass(c, a);

  CHECK(barriers_of([&] { a_to_b.run(); }).empty());
  CHECK(barriers_of([&] { a_to_c.run(); }).empty());                    // reads what the first one reads
  CHECK(barriers_of([&] { b_to_c.run(); }) == Bits{reads | kStorage});  // after the stores into b and c
  CHECK(barriers_of([&] { c_to_a.run(); }) == Bits{reads});  // the barrier before it was after the reads of a
  CHECK(barriers_of([&] { b.read<std::uint32_t>(); }) == Bits{kUpdate});  // of a as well: one barrier is for all
  CHECK(barriers_of([&] { a.read<std::uint32_t>(); }).empty());
  CHECK(a.read<std::uint32_t>() == std::vector<std::uint32_t>(64, 4));
  a_to_b.run();
  CHECK(barriers_of([&] { b.upload(0, 256, ones.data()); }) == Bits{kUpdate});
  CHECK(barriers_of([&] { b.upload(0, 256, ones.data()); }).empty());
  a_to_b.run();
  CHECK(barriers_of([&] { c.copy(b, 256); }) == Bits{kUpdate});
  a_to_b.run();
  CHECK(barriers_of([&] { c.clear(); }).empty());
  CHECK(barriers_of([&] { b.clear(); }) == Bits{kUpdate});
}

TEST_CASE("stores wait for draws, and draws for stores") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write("copy.comp", kCopy);
  ProgramCache programs(folder.path(), LoadPath::storage);
  const std::vector<std::uint32_t> ones(64, 1);
  Buffer a("a", ones), b("b", ones);
  const ComputePass a_to_b(programs.compute("copy.comp"), {{"source", &a}, {"target", &b}}, 64);
  a_to_b.run();
  CHECK(barriers_of([&] { b.before_draw(kVertices); }) == Bits{kVertices});
  CHECK(barriers_of([&] { b.before_draw(kVertices); }).empty());
  CHECK(barriers_of([&] { b.before_draw(kTexel); }) == Bits{kTexel});
  CHECK(barriers_of([&] { a.before_draw(kVertices); }).empty());
  CHECK(barriers_of([&] { a_to_b.run(); }) == Bits{kStorage});
  b.shader_access().read_by_others();
  for (int i = 0; i < 2; ++i) CHECK(barriers_of([&] { a_to_b.run(); }) == Bits{kStorage});
}

TEST_CASE("the numbers of groups of an indirect dispatch wait for the kernel that makes them") {
  const auto context = test::each_context();
  ShaderFolder folder;
  folder.write("copy.comp", kCopy);
  ProgramCache programs(folder.path(), LoadPath::storage);
  const std::vector<std::uint32_t> zeros(64, 0);
  Buffer a("a", zeros), groups("groups", zeros), b("b", zeros);
  const Program& copy = programs.compute("copy.comp");
  ComputePass(copy, {{"source", &a}, {"target", &groups}}, 3).run();
  ComputePass indirect(copy, {{"source", &a}, {"target", &b}}, 64);
  indirect.set_indirect(groups, 0);
  CHECK(barriers_of([&] { indirect.run(); }) == Bits{kCommand});
  CHECK(b.read<std::uint32_t>() == std::vector<std::uint32_t>(64, 1));
}

TEST_CASE("another context begins without barriers") {
  const auto context = test::each_context();
  const std::uint64_t command = next_command();
  ShaderAccess access;
  access.stored_by(command);
  CHECK(access.missing(kUpdate) == kUpdate);
  make_barrier(kUpdate | kStorage);
  CHECK(access.missing(kUpdate) == 0);
  CHECK(access.missing_before_store() == 0);
  CHECK(access.missing(kVertices) == kVertices);
  forget_barriers();
  CHECK(access.missing(kUpdate) == kUpdate);
  CHECK(barriers_of([&] { make_barrier(0); }).empty());
}

}  // namespace fascia::gl
