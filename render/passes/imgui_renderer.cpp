#include "render/passes/imgui_renderer.h"

#include <imgui.h>

#include <cstddef>
#include <cstdint>

namespace fascia {
namespace {

gl::Texture font_atlas() {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  return gl::Texture("panel font", GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

template <class T>
void stream(GLenum target, const ImVector<T>& data) {
  gl::BufferData(target, static_cast<GLsizeiptr>(data.size_in_bytes()), data.Data, GL_STREAM_DRAW);
}

}  // namespace

ImguiRenderer::ImguiRenderer(gl::ProgramCache& programs)
    : program_(programs.draw("draw/imgui.vert", "draw/imgui.frag")), font_(font_atlas()) {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.BackendRendererName = "fascia";
  io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(font_.id())));

  gl::GenVertexArrays(1, &vertex_array_);
  gl::GenBuffers(1, &vertices_);
  gl::GenBuffers(1, &indices_);
  gl::BindVertexArray(vertex_array_);
  gl::BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  const auto attribute = [](GLuint location, GLint size, GLenum type, std::size_t at) {
    gl::VertexAttribPointer(location, size, type, type == GL_UNSIGNED_BYTE, sizeof(ImDrawVert), offset(at));
    gl::EnableVertexAttribArray(location);
  };
  attribute(0, 2, GL_FLOAT, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, offsetof(ImDrawVert, col));
}

ImguiRenderer::~ImguiRenderer() {
  gl::DeleteBuffers(1, &vertices_);
  gl::DeleteBuffers(1, &indices_);
  gl::DeleteVertexArrays(1, &vertex_array_);
}

void ImguiRenderer::draw(const ImDrawData& data) {
  const ImVec2 scale = data.FramebufferScale, origin = data.DisplayPos, size = data.DisplaySize;
  const int width = static_cast<int>(size.x * scale.x), height = static_cast<int>(size.y * scale.y);
  if (width <= 0 || height <= 0) return;  // a minimized window

  gl::Viewport(0, 0, width, height);
  gl::Disable(GL_DEPTH_TEST);
  gl::Disable(GL_CULL_FACE);
  gl::Enable(GL_SCISSOR_TEST);
  gl::Enable(GL_BLEND);
  gl::BlendEquation(GL_FUNC_ADD);
  gl::BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  program_.use();
  program_.set("view", origin.x, origin.y, 2 / size.x, 2 / size.y);
  gl::ActiveTexture(GL_TEXTURE0);
  gl::BindVertexArray(vertex_array_);
  gl::BindBuffer(GL_ARRAY_BUFFER, vertices_);

  constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  for (int n = 0; n < data.CmdListsCount; ++n) {
    const ImDrawList& list = *data.CmdLists[n];
    stream(GL_ARRAY_BUFFER, list.VtxBuffer);
    stream(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback) {
        if (command.UserCallback != ImDrawCallback_ResetRenderState) command.UserCallback(&list, &command);
        continue;
      }
      const ImVec4& clip = command.ClipRect;  // left, top, right, bottom
      const int left = static_cast<int>((clip.x - origin.x) * scale.x),
                top = static_cast<int>((clip.y - origin.y) * scale.y);
      const int right = static_cast<int>((clip.z - origin.x) * scale.x);
      const int bottom = static_cast<int>((clip.w - origin.y) * scale.y);
      if (right <= left || bottom <= top) continue;
      gl::Scissor(left, height - bottom, right - left, bottom - top);
      gl::BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
      gl::DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                                 offset(command.IdxOffset * sizeof(ImDrawIdx)), static_cast<GLint>(command.VtxOffset));
    }
  }
  gl::Disable(GL_SCISSOR_TEST);
  gl::Disable(GL_BLEND);
  gl::Enable(GL_DEPTH_TEST);
}

}  // namespace fascia
