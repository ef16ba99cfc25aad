// OpenGL 4.3 core functions as variables in fascia::gl, filled from the context that is current. No GL symbol
// is linked, so one program serves GLFW, OSMesa and EGL contexts, also several in one process.
#pragma once
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES  // declarations only: nothing links against them
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
  X(ClearBufferData) X(ClearColor) X(ClientWaitSync) X(ColorMask) X(CompileShader) \
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

/// Fills every function above from the current context. Throws Error naming what is missing and what was
/// found when the context is below 4.3 or has no compute shaders.
void load(GetProc get_proc);

/// Why the context was lost, GL_NO_ERROR while it is not; null where the driver does not tell. Filled by load().
extern GLenum (*GetGraphicsResetStatus)();
/// Throws ContextLost when a reset of the device has taken what the context held. Asks the driver; waits for nothing.
void require_context();

class ContextLost : public Error {
 public:
  using Error::Error;
};

/// Takes the errors that were made so far out of OpenGL's list. A lost context may have no end of them.
void forget_errors();

/// What the current context is: filled by load().
struct Device {
  std::string renderer;                     // GL_RENDERER
  std::string version;                      // GL_VERSION
  bool software = false;                    // computed by the CPU: llvmpipe, softpipe, ...
  int max_texture_buffer_size = 0;          // texels
  int max_compute_storage_blocks = 0;       // SSBO blocks in one compute kernel
  int max_compute_textures = 0;             // buffer textures in one compute kernel
  int vector_width = 0;                     // of llvmpipe: invocations that it computes at once; 0 for others
  std::int64_t max_storage_block_size = 0;  // [bytes]
  int max_compute_groups = 0;               // work groups along x in one dispatch
  int timestamp_bits = 0;     // that GL_TIMESTAMP counts with; 0 where it says nothing: on software renderers
  bool links_beside = false;  // tells whether a program is linked yet (KHR_parallel_shader_compile)
};
const Device& device();

/// What decides whether a context can serve; the limits are those that OpenGL 4.3 guarantees.
struct Support {
  std::string renderer, version;
  int major = 0, minor = 0;
  int storage_blocks = 0;  // in one compute kernel
  int invocations = 0;     // in one work group
  int shared_memory = 0;   // [bytes]
  std::vector<std::string> missing_functions;
};
/// One line: what was found, what is missing. Empty when nothing is.
std::string refusal(const Support& found);

}  // namespace fascia::gl
