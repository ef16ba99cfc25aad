// OpenGL 4.3 core functions as variables in fascia::gl, filled from the context that is current. No GL symbol is
// linked, so one program serves GLFW, OSMesa and EGL contexts, even several in one process.
#pragma once
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES  // declarations only: nothing links to them
#endif
#include <GL/glcorearb.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"

namespace fascia::gl {

// clang-format off
#define FASCIA_GL_FUNCTIONS(X) /* without the gl prefix, alphabetical */ \
  X(ActiveTexture) X(AttachShader) X(BindBuffer) X(BindBufferBase) X(BindFramebuffer) \
  X(BindRenderbuffer) X(BindTexture) X(BindVertexArray) X(BlendEquation) X(BlendFuncSeparate) \
  X(BlitFramebuffer) X(BufferData) X(BufferSubData) X(CheckFramebufferStatus) X(Clear) \
  X(ClearColor) X(ClientWaitSync) X(ColorMask) X(CompileShader) \
  X(CopyBufferSubData) X(CreateProgram) X(CreateShader) X(DebugMessageCallback) \
  X(DebugMessageControl) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram) X(DeleteQueries) \
  X(DeleteRenderbuffers) X(DeleteShader) X(DeleteSync) X(DeleteTextures) X(DeleteVertexArrays) \
  X(DepthFunc) X(DepthMask) X(DetachShader) X(Disable) X(DispatchCompute) X(DispatchComputeIndirect) \
  X(DrawArrays) X(DrawArraysInstanced) X(DrawBuffer) X(DrawElements) X(DrawElementsBaseVertex) \
  X(Enable) X(EnableVertexAttribArray) X(FenceSync) X(Finish) X(FramebufferRenderbuffer) \
  X(FramebufferTexture2D) X(GenBuffers) X(GenFramebuffers) X(GenQueries) X(GenRenderbuffers) \
  X(GenTextures) X(GenVertexArrays) X(GetBufferSubData) X(GetError) X(GetInteger64v) X(GetIntegeri_v) \
  X(GetIntegerv) X(GetProgramInfoLog) X(GetProgramInterfaceiv) X(GetProgramResourceIndex) \
  X(GetProgramResourceName) X(GetProgramResourceiv) X(GetProgramiv) X(GetQueryObjectiv) \
  X(GetQueryObjectui64v) X(GetQueryiv) X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetStringi) \
  X(GetUniformLocation) X(IsEnabled) X(LinkProgram) X(MemoryBarrier) X(ObjectLabel) X(PixelStorei) X(ProgramUniform1f) \
  X(ProgramUniform1i) X(ProgramUniform1ui) X(ProgramUniform4f) X(ProgramUniformMatrix4fv) \
  X(QueryCounter) X(ReadBuffer) X(ReadPixels) X(RenderbufferStorageMultisample) X(Scissor) \
  X(ShaderSource) X(ShaderStorageBlockBinding) X(StencilFunc) X(StencilOp) X(StencilOpSeparate) \
  X(TexBuffer) X(TexImage2D) X(TexImage2DMultisample) X(TexParameterfv) X(TexParameteri) \
  X(TexSubImage2D) X(Uniform1ui) X(UniformBlockBinding) X(UseProgram) X(VertexAttribDivisor) \
  X(VertexAttribIPointer) X(VertexAttribPointer) X(Viewport)
// clang-format on

#define X(name) extern decltype(&::gl##name) name;
FASCIA_GL_FUNCTIONS(X)
#undef X

using GetProc = void* (*)(const char* name);

/// Fills every function above from the current context. Throws Error with the missing and the available features if the
/// context is below 4.3 or has no compute shaders.
void load(GetProc get_proc);

/// glBufferStorage, of OpenGL 4.4 or ARB_buffer_storage; null where there is neither. Filled by load().
extern decltype(&::glBufferStorage) BufferStorage;
/// The reason of a context loss, GL_NO_ERROR without one; null if the driver does not report it. Filled by load().
extern GLenum (*GetGraphicsResetStatus)();
/// Throws ContextLost if a device reset has destroyed the context's data. Queries the driver; does not wait.
void require_context();

class ContextLost : public Error {
 public:
  using Error::Error;
};

/// Clears OpenGL's list of errors. The list of a lost context may never end.
void forget_errors();

/// Properties of the current context; filled by load().
struct Device {
  std::string renderer;                     // GL_RENDERER
  std::string version;                      // GL_VERSION
  std::string uuid{};                       // tells equal devices apart, 16 bytes; empty where unknown
  bool software = false;                    // computed by the CPU: llvmpipe, softpipe, ...
  int max_texture_buffer_size = 0;          // texels
  int max_compute_storage_blocks = 0;       // SSBO blocks in one compute kernel
  int max_storage_bindings = 0;             // binding points of storage blocks
  int max_compute_textures = 0;             // buffer textures in one compute kernel
  int vector_width = 0;                     // for llvmpipe: number of invocations per vector; 0 for others
  std::int64_t max_storage_block_size = 0;  // [bytes]
  int max_compute_groups = 0;               // work groups along x in one dispatch
  int timestamp_bits = 0;                   // of GL_TIMESTAMP; 0 on software renderers, where it is undefined
  bool links_beside = false;                // whether the state of linking can be queried (KHR_parallel_shader_compile)
};
const Device& device();

/// The requirements on a context; the limits are those that OpenGL 4.3 guarantees.
struct Support {
  std::string renderer, version;
  int major = 0, minor = 0;
  int storage_blocks = 0;  // in one compute kernel
  int invocations = 0;     // in one work group
  int shared_memory = 0;   // [bytes]
  std::vector<std::string> missing_functions;
};
/// One line with the available and the missing features. Empty if nothing is missing.
std::string refusal(const Support& found);

}  // namespace fascia::gl
