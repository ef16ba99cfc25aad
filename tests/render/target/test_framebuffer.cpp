#include "render/target/framebuffer.h"

#include "gl/buffer.h"
#include "gl/program.h"
#include "tests/gl/gl_support.h"

namespace fascia {
namespace {

using Catch::Matchers::Contains;
using Pixel = std::array<int, 4>;

Pixel pixel_of(const Image& image, int x, int y) {
  const std::uint8_t* p = image.rgba.data() + 4 * (y * image.width + x);
  return {p[0], p[1], p[2], p[3]};
}

void clear(float r, float g, float b) {
  gl::ClearColor(r, g, b, 1);
  gl::Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

TEST_CASE("a picture is read top row first, with and without multisampling") {
  const auto context = test::each_context();
  const int samples = GENERATE(0, 1, 4);
  CAPTURE(samples);
  const Framebuffer framebuffer(7, 5, samples);
  CHECK(framebuffer.samples() == std::max(samples, 1));
  framebuffer.bind();
  clear(0, 0, 1);
  gl::Enable(GL_SCISSOR_TEST);
  gl::Scissor(0, 3, 7, 2);  // the upper two rows
  clear(1, 0, 0);
  gl::Scissor(0, 0, 1, 1);  // it must not affect resolving
  framebuffer.resolve();
  gl::Disable(GL_SCISSOR_TEST);
  const Image image = framebuffer.read();
  REQUIRE((image.width == 7 && image.height == 5));
  for (int y = 0; y < 5; ++y)
    for (const int x : {0, 6}) {
      CAPTURE(x, y);
      CHECK(pixel_of(image, x, y) == (y < 2 ? Pixel{255, 0, 0, 255} : Pixel{0, 0, 255, 255}));
    }
  CHECK(gl::GetError() == GL_NO_ERROR);
}

TEST_CASE("multisampling smooths an edge, and panels are drawn over the resolved picture") {
  const auto context = test::each_context();
  const test::ShaderFolder folder;
  folder.write("edge.vert",
               "void main() {\n  vec2 corner[3] = vec2[3](vec2(-1, -1), vec2(1, -1), vec2(-1, 1));\n"
               "  gl_Position = vec4(corner[gl_VertexID], 0, 1);\n}\n");
  folder.write("edge.frag", "out vec4 color;\nvoid main() { color = vec4(1); }\n");
  gl::ProgramCache programs(folder.path(), gl::LoadPath::storage);
  GLuint vertex_array = 0;
  gl::GenVertexArrays(1, &vertex_array);
  gl::BindVertexArray(vertex_array);
  const auto grays = [&](int samples) {
    const Framebuffer framebuffer(32, 24, samples);
    framebuffer.bind();
    clear(0, 0, 0);
    programs.draw("edge.vert", "edge.frag").use();
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    framebuffer.resolve();
    framebuffer.bind_resolved();
    gl::Enable(GL_SCISSOR_TEST);
    gl::Scissor(31, 23, 1, 1);
    clear(0, 1, 0);
    gl::Disable(GL_SCISSOR_TEST);
    const Image image = framebuffer.read();
    CHECK(pixel_of(image, 31, 0) == Pixel{0, 255, 0, 255});
    CHECK(pixel_of(image, 1, 22) == Pixel{255, 255, 255, 255});
    CHECK(pixel_of(image, 28, 2) == Pixel{0, 0, 0, 255});
    int count = 0;
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 31; ++x) count += pixel_of(image, x, y)[0] > 0 && pixel_of(image, x, y)[0] < 255;
    return count;
  };
  CHECK(grays(1) == 0);
  CHECK(grays(4) > 10);  // the diagonal crosses about 32 + 24 pixels
  gl::DeleteVertexArrays(1, &vertex_array);
}

TEST_CASE("an impossible framebuffer is an Error, and memory is counted") {
  const auto context = test::each_context();
  const std::size_t before = gl::allocated_bytes();
  CHECK_THAT(test::error_of([] { Framebuffer(0, 10, 1); }), Contains("framebuffer: width 0; expected 1 to "));
  CHECK_THAT(test::error_of([] { Framebuffer(10, 1 << 30, 1); }),
             Contains("framebuffer: height 1073741824; expected 1 to "));
  CHECK_THAT(test::error_of([] { Framebuffer(10, 10, 4096); }), Contains("framebuffer: samples 4096; expected 0 to "));
  CHECK_THAT(test::error_of([] { Framebuffer(10, 10, -1); }), Contains("framebuffer: samples -1"));
  CHECK(gl::allocated_bytes() == before);
  {
    const Framebuffer framebuffer(10, 10, 4);
    CHECK(gl::allocated_bytes() - before == 400 + 2 * 4 * 400);
  }
  CHECK(gl::allocated_bytes() == before);
}

}  // namespace fascia
