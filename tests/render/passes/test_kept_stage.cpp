// The kept picture of ground and background: pictures drawn over it are bitwise equal to those drawn without it.
#include "render/passes/kept_stage.h"

#include <algorithm>

#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// One renderer that draws the same scene repeatedly.
class Series {
 public:
  Series(gl::ProgramCache& programs, const test::Scene& scene)
      : renderer_(programs, scene.shape.triangles, static_cast<std::uint32_t>(scene.shape.positions.size()), {}),
        target_(scene.width, scene.height, scene.samples) {}

  Image draw(const test::Scene& scene) {
    const gl::Buffer positions = scene.shape.upload();
    renderer_.draw({&positions}, scene.camera, scene.look, {}, target_);
    target_.resolve();
    CHECK(gl::GetError() == GL_NO_ERROR);
    return target_.read();
  }

 private:
  SceneRenderer renderer_;
  Framebuffer target_;
};

long different(const Image& a, const Image& b) {
  REQUIRE(a.rgba.size() == b.rgba.size());
  long count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) count += a.rgba[i] != b.rgba[i];
  return count;
}

// The body stands on the ground, moves, and sinks into it.
void move(test::Scene& scene, const Vector3d& by) {
  for (Vector3d& p : scene.shape.positions) p += by;
}

}  // namespace

TEST_CASE("pictures over a kept stage are those without it to the bit") {
  const auto context = test::each_context();
  test::Scene scene(test::box({-0.4, 0, -0.3}, {0.4, 0.7, 0.3}, 3));
  scene.look.ground_height = 0;
  scene.camera.zoom(1.8);
  scene.look.shadow = GENERATE(true, false);
  scene.look.ground = GENERATE(true, false);
  scene.look.backdrop = GENERATE(Backdrop::gradient, Backdrop::white, Backdrop::black, Backdrop::transparent);
  scene.samples = scene.look.shadow && scene.look.ground ? GENERATE(1, 4) : 1;
  CAPTURE(scene.look.shadow, scene.look.ground, static_cast<int>(scene.look.backdrop), scene.samples);
  gl::ProgramCache programs(test::source_dir() / "shaders", gl::LoadPath::texel);
  Series kept(programs, scene);
  const auto check = [&](const char* after) {
    CAPTURE(after);
    const Image fresh = Series(programs, scene).draw(scene), drawn = kept.draw(scene);
    CHECK(different(fresh, drawn) == 0);
  };
  check("first");
  check("second, which keeps");
  move(scene, {0.1, 0.2, 0});
  check("third, with a body that has moved");
  move(scene, {-0.3, -0.35, 0.1});
  check("fourth, with a body that is partly below the ground");
  scene.camera.orbit(0.3, 0.1);
  check("another view");
  check("the same again");
  check("kept again");
  scene.look.depth_cue = 0.5;
  scene.look.heat_map = !scene.look.heat_map;
  check("another look of the body");
  scene.look.ambient_occlusion = 0.5;
  check("with ambient occlusion");
  scene.look.ambient_occlusion = 0;
  check("without, again");
  check("and again");
}

TEST_CASE("a stage is kept from the second picture of a view on, until the view changes") {
  const auto context = test::each_context();
  gl::ProgramCache programs(test::source_dir() / "shaders", gl::LoadPath::texel);
  const Ground ground(programs);
  const Framebuffer target(32, 24, 1), larger(64, 24, 1), multisampled(32, 24, 4);
  FrameUniforms frame;
  gl::Buffer uniforms("frame uniforms", sizeof(frame));
  uniforms.upload(0, sizeof(frame), &frame);
  gl::BindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms.id());
  Look look;
  KeptStage stage;
  const auto begins = [&](const Framebuffer& picture) { return stage.begin(ground, frame, look, true, picture); };
  CHECK_FALSE(begins(target));
  if (!gl::device().software) {  // drawn faster than read
    CHECK_FALSE(begins(target));
    return;
  }
  CHECK(begins(target));
  CHECK(begins(target));
  frame.heat_range << 1, 2, 3, 4;  // a value of the body
  CHECK(begins(target));
  frame.view_projection[3].x() = 0.25f;
  CHECK_FALSE(begins(target));
  CHECK(begins(target));
  look.shadow = !look.shadow;
  CHECK_FALSE(begins(target));
  CHECK(begins(target));
  CHECK_FALSE(begins(larger));
  CHECK_FALSE(begins(target));
  CHECK_FALSE(begins(multisampled));
  CHECK_FALSE(begins(multisampled));
  CHECK(gl::GetError() == GL_NO_ERROR);
}

}  // namespace fascia
