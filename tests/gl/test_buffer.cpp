// Buffers and textures: what they hold, and that their memory is counted.
// Covers: texture
#include "gl/buffer.h"

#include "gl/texture.h"
#include "tests/gl/gl_support.h"

namespace fascia::gl {

TEST_CASE("a buffer keeps its data") {
  const auto context = test::each_context();
  const std::vector<std::uint32_t> data = {1, 2, 3, 0xffffffffu, 5};
  Buffer buffer("numbers", data);
  CHECK(buffer.bytes() == 20);
  CHECK(buffer.label() == "numbers");
  CHECK(buffer.read<std::uint32_t>() == data);

  const std::uint32_t two[] = {70, 80};
  buffer.upload(4, 8, two);
  CHECK(buffer.read<std::uint32_t>() == std::vector<std::uint32_t>{1, 70, 80, 0xffffffffu, 5});
  std::uint32_t one = 0;
  buffer.download(8, 4, &one);
  CHECK(one == 80);
  CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("a buffer without data is zero") {
  const auto context = test::each_context();
  const std::size_t bytes = GENERATE(as<std::size_t>(), 0, 1, 7, 16, 4099);
  // The memory of a buffer that was full of ones is likely to be reused.
  { const Buffer dirty("dirty", std::vector<std::uint8_t>(bytes, 0xff)); }
  const Buffer buffer("zero", bytes);
  REQUIRE(buffer.id() != 0);
  CHECK(buffer.read<std::uint8_t>() == std::vector<std::uint8_t>(bytes, 0));
  CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("buffers move and count their memory") {
  const auto context = test::each_context();
  const std::size_t before = allocated_bytes();
  {
    Buffer a("a", std::vector<float>(100, 1.0f));
    CHECK(allocated_bytes() - before == 400);
    const GLuint view = a.texel_view(GL_R32F);
    const GLuint id = a.id();
    Buffer b(std::move(a));
    CHECK(b.id() == id);
    CHECK(b.texel_view(GL_R32F) == view);
    CHECK_FALSE(a);
    CHECK(a.bytes() == 0);
    b = Buffer("c", 48);
    CHECK(b.label() == "c");
    CHECK(allocated_bytes() - before == 48);
    CHECK(b.texel_view(GL_RGBA32F) == b.texel_view(GL_RGBA32F));
    CHECK(b.texel_view(GL_RGBA32F) != b.texel_view(GL_R32UI));
    const Texture texture("t", GL_RGBA8, 3, 5);
    CHECK(allocated_bytes() - before == 48 + 60);
  }
  CHECK(allocated_bytes() == before);
}

TEST_CASE("impossible sizes are an Error") {
  using Catch::Matchers::Contains;
  const auto context = test::each_context();
  const std::size_t before = allocated_bytes();
  CHECK_THAT(test::error_of([] { Buffer("huge", std::size_t{1} << 60); }),
             Contains("buffer huge") && Contains("1152921504606846976"));
  CHECK_THAT(test::error_of([] { Texture("wide", GL_RGBA8, 1 << 30, 4); }),
             Contains("texture wide: cannot have 1073741824 x 4"));
  const Buffer small("small", 64);
  CHECK_THAT(test::error_of([&] { small.texel_view(0x1234); }), Contains("texel format 4660"));
  CHECK(allocated_bytes() - before == 64);
}

TEST_CASE("textures hold pixels") {
  const auto context = test::each_context();
  const std::vector<std::uint8_t> pixels = {255, 0, 0, 255, 0, 255, 0, 255};
  Texture texture("two", GL_RGBA8, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  const Texture moved = std::move(texture);
  CHECK(texture.id() == 0);
  CHECK((moved.width() == 2 && moved.height() == 1 && moved.target() == GL_TEXTURE_2D));
  GLuint framebuffer = 0;
  GenFramebuffers(1, &framebuffer);
  BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, moved.id(), 0);
  std::vector<std::uint8_t> read(8);
  ReadPixels(0, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  CHECK(read == pixels);
  DeleteFramebuffers(1, &framebuffer);
  CHECK(Texture("depth", GL_DEPTH24_STENCIL8, 8, 8).id() != 0);
  CHECK(Texture("samples", GL_RGBA8, 8, 8, 4).target() == GL_TEXTURE_2D_MULTISAMPLE);
  CHECK(GetError() == GL_NO_ERROR);
}

}  // namespace fascia::gl
