#include "gl/downloads.h"

#include "tests/gl/gl_support.h"

namespace fascia::gl {

TEST_CASE("downloads bring the beginnings of several buffers") {
  const auto context = test::each_context();
  const Buffer a("a", std::vector<std::uint32_t>{1, 2, 3}), b("b", std::vector<float>{0.5f, 0.25f});
  Downloads downloads;
  std::uint32_t two[2] = {}, three[3] = {};
  float one = 0;
  downloads.add(a, sizeof two, two);
  downloads.add(b, sizeof one, &one);
  downloads.run();
  CHECK(two[0] == 1);
  CHECK(two[1] == 2);
  CHECK(one == 0.5f);
  downloads.add(a, sizeof three, three);
  downloads.run();
  CHECK(three[2] == 3);
  CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("downloads of nothing do nothing") {
  const auto context = test::each_context();
  Downloads downloads;
  downloads.run();
  std::uint32_t untouched = 7;
  const Buffer a("a", 4);
  downloads.add(a, 0, &untouched);
  downloads.run();
  CHECK(untouched == 7);
  CHECK(GetError() == GL_NO_ERROR);
}

}  // namespace fascia::gl
