#include "render/scene_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <limits>

#include "render/passes/ambient_occlusion.h"
#include "render/passes/edge_smoothing.h"
#include "render/passes/ground.h"
#include "render/passes/kept_stage.h"
#include "render/passes/marks.h"
#include "render/passes/rigid_renderer.h"
#include "render/passes/shadow_map.h"
#include "render/passes/surface_renderer.h"
#include "render/passes/tet_renderer.h"
#include "render/view/frame_uniforms.h"

namespace fascia {
namespace {

FrameUniforms frame_uniforms(const Camera& camera, const Look& look, int width, int height) {
  FrameUniforms frame;
  const Eigen::Matrix4f view_projection = camera.projection(double(width) / height, look.radius) * camera.view();
  for (int column = 0; column < 4; ++column) frame.view_projection[column] = view_projection.col(column);
  frame.eye << camera.eye.cast<float>(), 1;
  frame.up << look.up.normalized().cast<float>(), 0;
  frame.center << look.center.cast<float>(), float(look.radius);
  const double per_pixel = camera.pixel_size(camera.eye + camera.forward(), width, height);
  frame.picture << float(width), float(height), float(height) / 720, float(per_pixel);
  const Eigen::Vector2f ends = map_range(look);
  const float span = ends.y() - ends.x(), scale = span != 0 ? 1 / span : 0;
  const float first = (look.range.x() - ends.x()) * scale,
              last = look.neutral ? (look.range.y() - ends.x()) * scale : 1;
  frame.heat_range << ends.x(), scale, first, last;
  for (int k = 0; k < 7; ++k) {
    const auto& c = look.color_map->coefficients[static_cast<std::size_t>(k)];
    frame.color_map[k] << c[0], c[1], c[2], 0;
  }
  for (int n = 0; n < kRegionColors; ++n) {
    const Eigen::Vector3f color = region_color(static_cast<unsigned>(n));
    frame.region_color[n] << linear_of_srgb(color.x()), linear_of_srgb(color.y()), linear_of_srgb(color.z()), 0;
  }
  if (look.section) frame.section << look.section->normal, look.section->offset;
  if (look.tets) frame.spread.head<2>() << look.tets->shrink, look.tets->spread;
  const double center_depth = (look.center - camera.eye).dot(camera.forward());
  frame.spread.tail<2>() << look.depth_cue, static_cast<float>(center_depth - look.radius);
  ShadowMap::aim(look, frame);
  Ground::lay(look, frame);
  return frame;
}

// Unit vector along the longest side of the box around these points.
Eigen::Vector3f longest_side(std::span<const Eigen::Vector3d> points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  Eigen::Index axis = 0;
  if (!box.isEmpty()) box.sizes().maxCoeff(&axis);
  return Eigen::Vector3f::Unit(axis);
}

constexpr double kShadowLag = 0.01;  // of the scene's radius

// [m] between places of the same things.
double farthest(const std::vector<Eigen::Vector4f>& now, const std::vector<Eigen::Vector4f>& before) {
  if (now.size() != before.size()) return std::numeric_limits<double>::infinity();
  double farthest = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    farthest = std::max<double>(farthest, (now[i] - before[i]).head<3>().norm());
  return farthest;
}

}  // namespace

struct SceneRenderer::Impl {
  Impl(gl::ProgramCache& program_cache, std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t vertices,
       std::span<const std::uint32_t> marked, std::span<const Eigen::Vector3d> rest_positions,
       std::span<const std::uint32_t> colors)
      : programs(program_cache),
        vertex_count(vertices),
        surface(programs, make_surface_corners(triangles, vertices, rest_positions, colors)),
        rigid(programs),
        shadow(programs),
        ground(programs),
        marks(programs, marked),
        frame("frame uniforms", sizeof(FrameUniforms)),
        fibers(longest_side(rest_positions)) {}

  // The buffer with the paints of all regions, for a scene of this radius [m].
  void upload_paints(double radius) {
    std::vector<Eigen::Vector4f> vectors;
    for (const TissuePaint& paint : paints)
      for (const Eigen::Vector4f& vector : packed(paint, radius)) vectors.push_back(vector);
    paint_buffer = gl::Buffer("paints", vectors);
    paint_radius = radius;
  }

  // Ambient occlusion in the size of the target, or null if the look has none.
  const AmbientOcclusion* ambient_occlusion(const Look& look, const Framebuffer& target) {
    if (look.ambient_occlusion <= 0 || (occlusion && !occlusion->fits(target))) occlusion.reset();
    if (look.ambient_occlusion > 0 && !occlusion) occlusion.emplace(programs, target.width(), target.height());
    return occlusion ? &*occlusion : nullptr;
  }

  // Whether the shadow map is drawn for this picture: not while it may serve for more pictures under the same light. A
  // tool that moves fast takes tissue along, which an older map would darken in patches.
  bool shadow_due(const FrameUniforms& now, const Look& look, bool with_ground) {
    std::array<float, 17> aim{with_ground ? 1.0f : 0.0f};
    std::memcpy(&aim[1], &now.light_projection, 16 * sizeof(float));
    const bool moved = farthest(rigid_places, shadow_places) > kShadowLag * look.radius;
    if (aim == shadow_aim && !moved && ++shadow_pictures < look.quality.shadow_every) return false;
    shadow_places = rigid_places;
    shadow_aim = aim;
    shadow_pictures = 0;
    return true;
  }

  // Draws the cut of a closed surface whose tets end elsewhere. The signed count of surface hits of a pixel's ray
  // beyond the plane is the winding number of the surface at the ray's point on the plane. Where that is inside, the
  // cut is drawn: in the color of the tets where there are tets, and of plain tissue where the surface is away from
  // them.
  void draw_cut_within_surface(const Look& look, const gl::Buffer& positions, GLuint paint_view) const {
    gl::Enable(GL_STENCIL_TEST);
    gl::StencilFunc(GL_ALWAYS, 0, 0xff);
    gl::StencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    gl::StencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    gl::ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl::Disable(GL_DEPTH_TEST);  // it would reject surfaces behind others
    gl::Enable(GL_CLIP_DISTANCE0);
    surface.draw_bare(look);
    gl::Disable(GL_CLIP_DISTANCE0);
    gl::Enable(GL_DEPTH_TEST);
    gl::ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl::StencilFunc(GL_NOTEQUAL, 0, 0xff);
    gl::StencilOp(GL_KEEP, GL_KEEP, GL_ZERO);  // once per pixel
    tets->draw_cap(look, positions, paint_view);
    tets->draw_flesh(look);
    gl::Disable(GL_STENCIL_TEST);
  }

  gl::ProgramCache& programs;
  std::uint32_t vertex_count;
  TetView tet_view;
  std::optional<TetRenderer> tets;            // while a look needs them
  std::optional<AmbientOcclusion> occlusion;  // while a look needs it
  SurfaceRenderer surface;
  RigidRenderer rigid;
  ShadowMap shadow;
  std::array<float, 17> shadow_aim{};  // of the shadow map: with the ground, the light's projection
  int shadow_pictures = 0;             // drawn with the shadow map
  std::vector<Eigen::Vector4f> rigid_places, shadow_places;  // of rigid things: now, and in the shadow map
  Ground ground;
  KeptStage kept_stage;
  Marks marks;
  gl::Buffer frame;
  Eigen::Vector3f fibers;
  std::vector<TissuePaint> paints{TissuePaint{}};
  gl::Buffer paint_buffer;  // of several paints, for a scene of this radius
  double paint_radius = 0;
  std::optional<EdgeSmoothing> smoothing;  // while a look needs it
};

SceneRenderer::SceneRenderer(gl::ProgramCache& programs, std::span<const std::array<std::uint32_t, 3>> triangles,
                             std::uint32_t vertex_count, std::span<const std::uint32_t> marked,
                             std::span<const Eigen::Vector3d> rest_positions, std::span<const std::uint32_t> colors)
    : impl_(std::make_unique<Impl>(programs, triangles, vertex_count, marked, rest_positions, colors)) {}

SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::set_grabbed(std::span<const std::uint32_t> vertices) { impl_->marks.set_grabbed(vertices); }

void SceneRenderer::set_rigid(const RigidSurface& surface) {
  impl_->rigid.set(surface);
  impl_->rigid_places = surface.positions;
}
void SceneRenderer::set_tets(const TetView& view) { impl_->tet_view = view; }
void SceneRenderer::set_regions(std::span<const std::uint32_t> triangle_region) {
  impl_->surface.set_regions(triangle_region);
}
bool SceneRenderer::has_regions() const { return impl_->surface.has_regions(); }

void SceneRenderer::set_paints(std::span<const TissuePaint> paints) {
  assert(!paints.empty());
  impl_->paints.assign(paints.begin(), paints.end());
  impl_->paint_buffer = {};
}

void SceneRenderer::draw(const SurfaceView& surface, const Camera& camera, const Look& asked,
                         std::span<const GrabArrow> grabs, const Framebuffer& target) {
  Impl& parts = *impl_;
  assert(surface.positions->bytes() >= 16 * std::size_t(parts.vertex_count));
  const gl::Buffer& positions = *surface.positions;
  Look look = asked;
  look.regions &= parts.surface.has_regions();
  const bool has_tets = !parts.tet_view.tets.empty();
  if (!has_tets) {
    look.section.reset();
    look.tets.reset();
  }
  const bool needs_tets = look.section || look.tets;
  if (!needs_tets) parts.tets.reset();
  if (needs_tets && !parts.tets) parts.tets.emplace(parts.programs, parts.tet_view);

  FrameUniforms frame = frame_uniforms(camera, look, target.width(), target.height());
  const auto first = packed(parts.paints.front(), look.radius);
  std::copy(first.begin(), first.end(), frame.paint);
  frame.fibers << parts.fibers, 0;
  if (parts.paints.size() > 1 && (!parts.paint_buffer || parts.paint_radius != look.radius))
    parts.upload_paints(look.radius);
  const GLuint paints = parts.paint_buffer ? parts.paint_buffer.texel_view(GL_RGBA32F) : 0;
  parts.frame.upload(0, sizeof(frame), &frame);
  if (!look.tets) parts.surface.update(positions);
  gl::BindBufferBase(GL_UNIFORM_BUFFER, 0, parts.frame.id());

  gl::Disable(GL_BLEND);
  gl::Disable(GL_CULL_FACE);
  gl::Disable(GL_SCISSOR_TEST);
  gl::DepthFunc(GL_LEQUAL);
  const bool cut_surface = look.section && !look.tets;
  const auto clipped = [&](const auto& draw_surface) {
    if (cut_surface) gl::Enable(GL_CLIP_DISTANCE0);
    draw_surface();
    if (cut_surface) gl::Disable(GL_CLIP_DISTANCE0);
  };
  const bool above_ground = camera.eye.dot(look.up.normalized()) > look.ground_height;
  const bool ground = look.ground && above_ground;
  // The shadow map does not include the cut: light that enters through it still ends at the surface behind.
  const auto draw_depth = [&] {
    if (look.tets)
      parts.tets->draw_depth(look, positions);
    else
      clipped([&] { parts.surface.draw_depth(look); });
    parts.rigid.draw_depth(look);
  };
  if (look.shadow && parts.shadow_due(frame, look, ground)) parts.shadow.draw(draw_depth, ground);

  target.bind();
  gl::Enable(GL_DEPTH_TEST);
  gl::DepthMask(GL_TRUE);
  const bool transparent = look.backdrop == Backdrop::transparent;
  const bool has_stage = parts.kept_stage.begin(parts.ground, frame, look, ground, target);
  if (transparent) gl::ClearColor(0, 0, 0, 0);
  if (!has_stage) gl::Clear((transparent ? GL_COLOR_BUFFER_BIT : 0) | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  // From front to back, so that every pixel is shaded once: the fill rate limits software renderers.
  if (look.shadow) parts.shadow.bind_depth(0, !look.quality.contact_shadow);
  if (look.tets)
    parts.tets->draw_tets(look, positions, paints);
  else
    clipped([&] { parts.surface.draw(look, parts.surface.has_regions() ? paints : 0); });
  parts.rigid.draw(look);
  if (cut_surface && parts.tet_view.within_surface)
    parts.draw_cut_within_surface(look, positions, paints);
  else if (cut_surface)
    parts.tets->draw_cap(look, positions, paints);
  if (ground) {
    if (!has_stage) parts.ground.draw_unshadowed(look);
    if (look.shadow) parts.shadow.bind_ground_light(0);
    parts.ground.draw_shadowed(look);
  }
  const AmbientOcclusion* occlusion = parts.ambient_occlusion(look, target);
  if (occlusion) occlusion->darken(camera, look, target);
  if (!transparent && !has_stage) parts.ground.draw_background(look);
  // Pictures that are averaged from several are smooth already.
  const bool smooths = look.quality.edge_smoothing && target.samples() == 1 && camera.jitter.isZero();
  if (smooths && !(parts.smoothing && parts.smoothing->fits(target)))
    parts.smoothing.emplace(parts.programs, target.width(), target.height());
  if (!smooths) parts.smoothing.reset();
  if (smooths) parts.smoothing->smooth(target);
  if (!look.tets) parts.marks.draw(look, positions, grabs);  // separate tets are not drawn at the vertices
}

}  // namespace fascia
