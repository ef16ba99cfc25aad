#include "render/passes/shadow_map.h"

#include <Eigen/Geometry>

#include "render/view/camera.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kHalfSide = 1.8;    // half the map's side in scene radii: room for a body that is dragged around
constexpr double kDepthReach = 4;    // half the map's depth in scene radii; depths beyond it are clamped
constexpr double kLampSlope = 0.16;  // the light's size as the tangent of the angle that it subtends

void set_compare(const gl::Texture& texture, GLint mode) {
  gl::BindTexture(GL_TEXTURE_2D, texture.id());
  gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, mode);
}

Eigen::Vector4f vec4(const Vector3d& xyz, double w) {
  return {float(xyz.x()), float(xyz.y()), float(xyz.z()), float(w)};
}

}  // namespace

gl::Defines ShadowMap::defines() {
  constexpr double kFlatness = kHalfSide * kHalfSide / (kDepthReach * kDepthReach);
  return {{"SHADOW_SIZE", std::to_string(kSize) + ".0"},
          {"GROUND_SIZE", std::to_string(kGroundSize) + ".0"},
          {"SHADOW_FLATNESS", std::to_string(kFlatness)},
          {"PENUMBRA", std::to_string(kLampSlope * kDepthReach / kHalfSide)}};
}

ShadowMap::ShadowMap(gl::ProgramCache& programs)
    : cover_program_(programs.draw("draw/fullscreen.vert", "draw/ground/ground_cover.frag", defines())),
      light_program_(programs.draw("draw/fullscreen.vert", "draw/ground/ground_light.frag", defines())),
      depth_("shadow depth", GL_DEPTH_COMPONENT32F, kSize, kSize),
      ground_cover_("shadow cover of the ground", GL_RGBA8, kGroundSize, kGroundSize),
      ground_light_("shadow on the ground", GL_RGBA8, kGroundSize, kGroundSize),
      depth_target_(gl::make_target(GL_DEPTH_ATTACHMENT, depth_)),
      cover_target_(gl::make_target(GL_COLOR_ATTACHMENT0, ground_cover_)),
      light_target_(gl::make_target(GL_COLOR_ATTACHMENT0, ground_light_)) {
  gl::BindTexture(GL_TEXTURE_2D, depth_.id());
  const float far[] = {1, 1, 1, 1};
  gl::TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, far);
  gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

ShadowMap::~ShadowMap() {
  const GLuint targets[] = {depth_target_, cover_target_, light_target_};
  gl::DeleteFramebuffers(3, targets);
}

void ShadowMap::aim(const Look& look, FrameUniforms& frame) {
  const Eigen::Matrix3d standing = standing_axes(look.up);
  const Vector3d right = standing.col(0), up = standing.col(1), front = standing.col(2);
  const Vector3d light = (up + 0.50 * front - 0.55 * right).normalized();
  const Vector3d across = up.cross(light).normalized(), along = light.cross(across);
  const double side = 2 * kHalfSide * look.radius, deep = 2 * kDepthReach * look.radius;
  Eigen::Matrix<double, 3, 3> rows;
  rows << across.transpose() / side, along.transpose() / side, -light.transpose() / deep;
  const Vector3d shift = Vector3d::Constant(0.5) - rows * look.center;
  for (int column = 0; column < 3; ++column) frame.light_projection[column] = vec4(rows.col(column), 0);
  frame.light_projection[3] = vec4(shift, 1);
  frame.light = vec4(light, side / kSize);

  // A point of the map, projected along the light to the ground.
  const auto on_ground = [&](double u, double v) {
    const Vector3d start = look.center + across * (u - 0.5) * side + along * (v - 0.5) * side;
    return Vector3d(start + light * ((look.ground_height - start.dot(up)) / light.dot(up)));
  };
  const auto depth = [&](const Vector3d& p) { return (rows * p + shift).z(); };
  const Vector3d origin = on_ground(0, 0), to_u = on_ground(1, 0), to_v = on_ground(0, 1);
  frame.ground_origin = vec4(origin, depth(origin));
  frame.ground_u = vec4(to_u - origin, depth(to_u) - depth(origin));
  frame.ground_v = vec4(to_v - origin, depth(to_v) - depth(origin));
}

void ShadowMap::draw(const std::function<void()>& draw_depth, bool ground) const {
  gl::BindFramebuffer(GL_FRAMEBUFFER, depth_target_);
  gl::Viewport(0, 0, kSize, kSize);
  gl::Enable(GL_DEPTH_TEST);
  gl::DepthMask(GL_TRUE);
  gl::Enable(GL_DEPTH_CLAMP);
  gl::Clear(GL_DEPTH_BUFFER_BIT);
  draw_depth();
  gl::Disable(GL_DEPTH_CLAMP);
  if (!ground) return;
  gl::Viewport(0, 0, kGroundSize, kGroundSize);
  gl::Disable(GL_DEPTH_TEST);
  gl::ActiveTexture(GL_TEXTURE0);
  no_vertices_.bind();
  gl::BindFramebuffer(GL_FRAMEBUFFER, cover_target_);
  set_compare(depth_, GL_NONE);
  cover_program_.use();
  gl::DrawArrays(GL_TRIANGLES, 0, 3);
  gl::BindFramebuffer(GL_FRAMEBUFFER, light_target_);
  gl::BindTexture(GL_TEXTURE_2D, ground_cover_.id());
  light_program_.use();
  gl::DrawArrays(GL_TRIANGLES, 0, 3);
  gl::Enable(GL_DEPTH_TEST);
}

void ShadowMap::bind_depth(GLuint unit, bool compared) const {
  gl::ActiveTexture(GL_TEXTURE0 + unit);
  set_compare(depth_, compared ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
}

void ShadowMap::bind_ground_light(GLuint unit) const {
  gl::ActiveTexture(GL_TEXTURE0 + unit);
  gl::BindTexture(GL_TEXTURE_2D, ground_light_.id());
}

}  // namespace fascia
