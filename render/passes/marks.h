// Marks over the surface: dots on fixed and grabbed vertices, and an arrow for every grab.
#pragma once
#include <cstdint>
#include <span>

#include "gl/program.h"
#include "render/passes/vertex_array.h"
#include "render/view/look.h"

namespace fascia {

class Marks {
 public:
  Marks(gl::ProgramCache& programs, std::span<const std::uint32_t> fixed);
  void set_grabbed(std::span<const std::uint32_t> vertices);
  void draw(const Look& look, const gl::Buffer& positions, std::span<const GrabArrow> grabs) const;

 private:
  struct Dots {
    gl::Buffer vertices;
    GLsizei count = 0;
    VertexArray vertex_array;
    void set(const char* label, std::span<const std::uint32_t> list);
  };
  struct Style {
    float radius;  // [points]
    Eigen::Vector4f fill, border;
  };
  void draw_dots(const gl::Program& program, const Dots& dots, const Style& style) const;

  gl::ProgramCache& programs_;
  const gl::Program& arrow_program_;
  Dots fixed_, grabbed_;
  VertexArray no_vertices_;
};

}  // namespace fascia
