// Draws a deforming surface from buffers that stay on the GPU: smooth normals, light, soft shadow, ground grid, heat map,
// wireframe, marks. Knows triangles and positions, nothing of tissue.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/camera.h"
#include "render/gl/buffer.h"
#include "render/gl/program.h"

namespace fascia {

/// Where the surface is this frame. Handed over by the solver, owned by it.
struct SurfaceView {
  const gl::Buffer* positions = nullptr;  // vec4 [vertex_count]: x, y, z [m], w the scalar shown by the heat map
};

struct Look {
  bool wireframe = false;
  bool heat_map = false;                   // color by position.w over `range`, else by `color`
  Eigen::Vector2f range{0, 1};
  Eigen::Vector3f color{0.80f, 0.34f, 0.29f};  // tissue
  bool shadow = true, ground = true;
  double ground_height = 0;                // y of the ground plane [m]
  Eigen::Vector3d center{0, 0, 0};         // of the scene at rest [m]
  double radius = 1;                       // of the scene at rest [m]: sets light, shadow and grid scale
  Eigen::Vector3d up{0, 1, 0};
};

/// A stretched spring from the grabbed patch to the mouse.
struct GrabMark {
  Eigen::Vector3f from, to;
};

class SceneRenderer {
 public:
  /// `triangles` index the vertices of SurfaceView::positions. `marked` are vertices drawn as dots (fixed ones).
  SceneRenderer(gl::ProgramCache& programs, std::span<const std::array<std::uint32_t, 3>> triangles,
                std::uint32_t vertex_count, std::span<const std::uint32_t> marked);
  ~SceneRenderer();

  /// Vertices of the grabbed patch, drawn as brighter dots; empty lets go.
  void set_grabbed(std::span<const std::uint32_t> vertices);

  /// Into the framebuffer that is bound, of this size. The framebuffer is left bound.
  void draw(const SurfaceView& surface, const Camera& camera, const Look& look, const std::optional<GrabMark>& grab,
            GLuint framebuffer, int width, int height);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Color of the heat map at t in [0, 1] (viridis-like, perceptually uniform): for the color bar. The shader uses the same.
Eigen::Vector3f heat_color(float t);

}  // namespace fascia
