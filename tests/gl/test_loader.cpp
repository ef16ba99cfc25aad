#include "gl/loader.h"

#include "tests/gl/gl_support.h"

namespace fascia::gl {
namespace {

using Catch::Matchers::Contains;

Support sufficient() {
  Support s;
  s.renderer = "Some GPU";
  s.version = "4.3.0 Core";
  s.major = 4;
  s.minor = 3;
  s.storage_blocks = 8;
  s.invocations = 1024;
  s.shared_memory = 32768;
  return s;
}

GLenum reset_status = GL_NO_ERROR;
GLenum fake_reset_status() { return reset_status; }

}  // namespace

TEST_CASE("a device reset is an error, but a device that cannot report resets is accepted") {
  auto* const own = GetGraphicsResetStatus;
  GetGraphicsResetStatus = nullptr;
  CHECK_NOTHROW(require_context());
  GetGraphicsResetStatus = fake_reset_status;
  reset_status = GL_NO_ERROR;
  CHECK_NOTHROW(require_context());
  reset_status = GL_GUILTY_CONTEXT_RESET;
  CHECK_THROWS_WITH(require_context(),
                    Contains("the device was reset, caused by this program, and what it held is lost"));
  reset_status = GL_UNKNOWN_CONTEXT_RESET;
  CHECK_THROWS_AS(require_context(), ContextLost);
  GetGraphicsResetStatus = own;
}

TEST_CASE("the limits that OpenGL 4.3 guarantees are enough") {
  CHECK(refusal(sufficient()) == "");
  Support newer = sufficient();
  newer.major = 5;
  newer.minor = 0;
  CHECK(refusal(newer) == "");
}

TEST_CASE("a context below 4.3 is refused with the available and the missing features") {
  Support mac;
  mac.renderer = "Apple M1";
  mac.version = "4.1 Metal - 88";
  mac.major = 4;
  mac.minor = 1;
  mac.missing_functions = {"glDispatchCompute"};
  CHECK(refusal(mac) == "OpenGL: found version 4.1 Metal - 88 on Apple M1; missing: version 4.3 with compute shaders");
  CHECK(refusal({}) == "OpenGL: found version none on an unknown renderer; missing: version 4.3 with compute shaders");
}

TEST_CASE("every limit that is too low is named with its actual value") {
  Support weak = sufficient();
  weak.storage_blocks = 4;
  weak.invocations = 512;
  weak.shared_memory = 16384;
  weak.missing_functions = {"glDispatchCompute"};
  const std::string message = refusal(weak);
  CHECK_THAT(message, Contains("8 storage blocks in a compute shader (found 4)"));
  CHECK_THAT(message, Contains("1024 invocations in a work group (found 512)"));
  CHECK_THAT(message, Contains("32768 bytes of shared memory (found 16384)"));
  CHECK_THAT(message, Contains("glDispatchCompute"));
  CHECK(message.find('\n') == std::string::npos);
}

TEST_CASE("a loader that finds no function reports an error instead of crashing") {
  CHECK_THAT(test::error_of([] { load([](const char*) -> void* { return nullptr; }); }),
             Contains("OpenGL: found version none"));
  const auto context = test::each_context();  // restores the function table
  CHECK(GetString(GL_RENDERER) != nullptr);
}

TEST_CASE("the device is described") {
  const auto context = test::each_context();
  CAPTURE(device().renderer, device().version);
  CHECK(device().renderer == reinterpret_cast<const char*>(GetString(GL_RENDERER)));
  CHECK(device().version == reinterpret_cast<const char*>(GetString(GL_VERSION)));
  CHECK(device().software == (device().renderer.find("llvmpipe") != std::string::npos));
  CHECK(device().max_compute_storage_blocks >= 8);
  CHECK(device().max_texture_buffer_size >= 65536);
  CHECK(device().max_compute_groups >= 65535);
  CHECK(device().max_storage_block_size >= 1 << 24);
}

}  // namespace fascia::gl
