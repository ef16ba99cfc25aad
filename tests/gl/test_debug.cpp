#include "gl/debug.h"

#include "gl/loader.h"
#include "tests/gl/gl_support.h"

namespace fascia::gl {

TEST_CASE("an error reaches the debug sink") {
  const auto context = test::each_context();
  std::vector<std::string> messages;
  log_debug_messages([&](const std::string& line) { messages.push_back(line); });
  Enable(0x1234);  // no such capability
  CHECK(GetError() == GL_INVALID_ENUM);
  log_debug_messages({});
  REQUIRE(messages.size() == 1);
  CHECK_THAT(messages[0], Catch::Matchers::StartsWith("OpenGL error"));
  CHECK(messages[0].find('\n') == std::string::npos);
  Enable(0x1234);
  CHECK(GetError() == GL_INVALID_ENUM);
  CHECK(messages.size() == 1);
}

}  // namespace fascia::gl
