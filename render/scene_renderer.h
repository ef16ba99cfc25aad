// Draws a deforming surface from buffers that stay on the GPU: smooth normals, light, soft shadow, ground grid, heat
// map, wireframe, marks. It uses only triangles and positions and does not depend on the solver.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "gl/buffer.h"
#include "gl/program.h"
#include "render/passes/rigid_renderer.h"
#include "render/passes/tet_renderer.h"
#include "render/target/framebuffer.h"
#include "render/view/camera.h"
#include "render/view/look.h"
#include "render/view/tissue_paint.h"

namespace fascia {

/// The surface of this frame, provided and owned by the solver.
struct SurfaceView {
  const gl::Buffer* positions = nullptr;  // vec4 [vertex_count]: x, y, z [m], w the scalar shown by the heat map
};

class SceneRenderer {
 public:
  /// `triangles` index the vertices of SurfaceView::positions. `marked` are vertices drawn as dots (fixed ones). With
  /// `rest_positions` [vertex_count], edges that are sharp at rest (a box's) stay sharp in the shading; without,
  /// everything is shaded smooth and without Quality::detail. `colors` [3 * triangle_count] of the triangles' corners,
  /// sRGB 0xAABBGGRR, replace the color of the paint where AA is ff; without, they cost nothing.
  SceneRenderer(gl::ProgramCache& programs, std::span<const std::array<std::uint32_t, 3>> triangles,
                std::uint32_t vertex_count, std::span<const std::uint32_t> marked,
                std::span<const Eigen::Vector3d> rest_positions = {}, std::span<const std::uint32_t> colors = {});
  ~SceneRenderer();

  /// Sets the vertices of the grabbed patch, drawn as brighter dots; empty: none.
  void set_grabbed(std::span<const std::uint32_t> vertices);

  /// Sets the rigid things beside the tissue, at their places.
  void set_rigid(const RigidSurface& surface);
  /// Sets the tets for looks with a section plane or separate tets; the spans must outlive the renderer. Uploaded while
  /// a look needs them.
  void set_tets(const TetView& view);
  /// Sets the region of every triangle, for looks that color by it and for several paints; empty frees the regions.
  void set_regions(std::span<const std::uint32_t> triangle_region);
  bool has_regions() const;
  /// Sets the paint of every region, or of all tissue if there is only one. Several paints show on surfaces with
  /// regions and on tets.
  void set_paints(std::span<const TissuePaint> paints);

  /// Draws over the whole of `target`, which need not be cleared and stays bound, with depth test on and blending off.
  /// On a transparent backdrop colors are premultiplied by alpha.
  void draw(const SurfaceView& surface, const Camera& camera, const Look& look, std::span<const GrabArrow> grabs,
            const Framebuffer& target);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fascia
