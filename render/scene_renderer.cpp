#include "render/scene_renderer.h"

#include <cassert>
#include <cmath>

#include "render/frame_uniforms.h"
#include "render/ground.h"
#include "render/marks.h"
#include "render/shadow_map.h"
#include "render/surface_renderer.h"

namespace fascia {
namespace {

float linear(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

FrameUniforms frame_uniforms(const Camera& camera, const Look& look, int width, int height) {
  FrameUniforms frame{};
  const Eigen::Matrix4f view_projection =
      camera.projection(double(width) / height, look.radius) * camera.view();
  for (int column = 0; column < 4; ++column) frame.view_projection[column] = view_projection.col(column);
  frame.eye << camera.eye.cast<float>(), 1;
  frame.up << look.up.normalized().cast<float>(), 0;
  frame.center << look.center.cast<float>(), float(look.radius);
  const double per_pixel = camera.pixel_size(camera.eye + camera.forward(), height);
  frame.picture << float(width), float(height), float(height) / 720, float(per_pixel);
  for (int c = 0; c < 3; ++c) frame.base_color[c] = linear(look.color[c]);
  const float span = look.range.y() - look.range.x();
  frame.heat_range << look.range.x(), span != 0 ? 1 / span : 0, 0, 0;
  ShadowMap::aim(look, frame);
  Ground::lay(look, frame);
  return frame;
}

}  // namespace

struct SceneRenderer::Impl {
  Impl(gl::ProgramCache& programs, std::span<const std::array<std::uint32_t, 3>> triangles,
       std::uint32_t vertices, std::span<const std::uint32_t> marked,
       std::span<const Eigen::Vector3d> rest_positions)
      : vertex_count(vertices),
        surface(programs, make_surface_corners(triangles, vertices, rest_positions)),
        shadow(programs),
        ground(programs),
        marks(programs, marked),
        frame("frame uniforms", sizeof(FrameUniforms)) {}

  std::uint32_t vertex_count;
  SurfaceRenderer surface;
  ShadowMap shadow;
  Ground ground;
  Marks marks;
  gl::Buffer frame;
};

SceneRenderer::SceneRenderer(gl::ProgramCache& programs,
                             std::span<const std::array<std::uint32_t, 3>> triangles,
                             std::uint32_t vertex_count, std::span<const std::uint32_t> marked,
                             std::span<const Eigen::Vector3d> rest_positions)
    : impl_(std::make_unique<Impl>(programs, triangles, vertex_count, marked, rest_positions)) {}

SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::set_grabbed(std::span<const std::uint32_t> vertices) {
  impl_->marks.set_grabbed(vertices);
}

void SceneRenderer::draw(const SurfaceView& surface, const Camera& camera, const Look& look,
                         const std::optional<GrabMark>& grab, const Framebuffer& target) {
  Impl& parts = *impl_;
  assert(surface.positions->bytes() >= 16 * std::size_t(parts.vertex_count));
  const FrameUniforms frame = frame_uniforms(camera, look, target.width(), target.height());
  parts.frame.upload(0, sizeof(frame), &frame);
  parts.surface.update(*surface.positions);
  gl::BindBufferBase(GL_UNIFORM_BUFFER, 0, parts.frame.id());

  gl::Disable(GL_BLEND);
  gl::Disable(GL_CULL_FACE);
  gl::Disable(GL_SCISSOR_TEST);
  gl::DepthFunc(GL_LEQUAL);
  const bool above_ground = camera.eye.dot(look.up.normalized()) > look.ground_height;
  const bool ground = look.ground && above_ground;
  if (look.shadow) parts.shadow.draw([&] { parts.surface.draw_depth(); }, ground);

  target.bind();
  gl::Enable(GL_DEPTH_TEST);
  gl::DepthMask(GL_TRUE);
  gl::Clear(GL_DEPTH_BUFFER_BIT);
  // From front to back, so that every pixel is lit once: software renderers live by their fill rate.
  if (look.shadow) parts.shadow.bind_depth(0);
  parts.surface.draw(look);
  if (ground) {
    if (look.shadow) parts.shadow.bind_ground_light(0);
    parts.ground.draw(look.shadow);
  }
  parts.ground.draw_background();
  parts.marks.draw(*surface.positions, grab);
}

}  // namespace fascia
