#include "gl/loader.h"

#include <array>
#include <cctype>
#include <cstdio>

#include "gl/barriers.h"

namespace fascia::gl {

#define X(name) decltype(&::gl##name) name = nullptr;
FASCIA_GL_FUNCTIONS(X)
#undef X
decltype(&::glBufferStorage) BufferStorage = nullptr;
GLenum (*GetGraphicsResetStatus)() = nullptr;

namespace {

Device current_device;

std::string string_of(GLenum name) {
  const GLubyte* text = GetString ? GetString(name) : nullptr;
  return text ? reinterpret_cast<const char*>(text) : "";
}

int integer_of(GLenum name) {
  GLint value = 0;
  GetIntegerv(name, &value);
  return value;
}

bool is_software(std::string renderer) {
  for (char& c : renderer)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));  // "virgl (LLVMPIPE ...)"
  for (const char* word : {"llvmpipe", "softpipe", "swrast", "software rasterizer", "basic render"})
    if (renderer.find(word) != std::string::npos) return true;
  return false;
}

bool has_extension(const std::string& name) {
  for (GLuint i = 0; i < static_cast<GLuint>(integer_of(GL_NUM_EXTENSIONS)); ++i)
    if (name == reinterpret_cast<const char*>(GetStringi(GL_EXTENSIONS, i))) return true;
  return false;
}

/// EXT_memory_object, which Khronos's core header lacks.
std::string device_uuid(GetProc get_proc) {
  constexpr GLenum kDeviceUuid = 0x9597;  // GL_DEVICE_UUID_EXT
  constexpr std::size_t kBytes = 16;      // GL_UUID_SIZE_EXT
  const auto read = reinterpret_cast<void (*)(GLenum, GLuint, GLubyte*)>(get_proc("glGetUnsignedBytei_vEXT"));
  if (!read || !has_extension("GL_EXT_memory_object")) return "";
  std::array<GLubyte, kBytes> bytes{};
  read(kDeviceUuid, 0, bytes.data());
  if (GetError() != GL_NO_ERROR || bytes == std::array<GLubyte, kBytes>{}) return "";
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string refusal(const Support& found) {
  std::string missing;
  const auto add = [&](const std::string& what) { missing += (missing.empty() ? "" : ", ") + what; };
  const auto limit = [&](const char* what, int value, int least) {
    if (value < least) add(std::to_string(least) + " " + what + " (found " + std::to_string(value) + ")");
  };
  if (found.major < 4 || (found.major == 4 && found.minor < 3)) {
    add("version 4.3 with compute shaders");  // the limits below do not exist before it
  } else {
    limit("storage blocks in a compute shader", found.storage_blocks, 8);
    limit("invocations in a work group", found.invocations, 1024);
    limit("bytes of shared memory", found.shared_memory, 32768);
    for (const std::string& name : found.missing_functions) add(name);
  }
  if (missing.empty()) return "";
  return "OpenGL: found version " + (found.version.empty() ? "none" : found.version) + " on " +
         (found.renderer.empty() ? "an unknown renderer" : found.renderer) + "; missing: " + missing;
}

void load(GetProc get_proc) {
  Support found;
#define X(name)                                                         \
  name = reinterpret_cast<decltype(&::gl##name)>(get_proc("gl" #name)); \
  if (!name) found.missing_functions.push_back("gl" #name);
  FASCIA_GL_FUNCTIONS(X)
#undef X
  for (const char* name : {"glGetGraphicsResetStatus", "glGetGraphicsResetStatusKHR", "glGetGraphicsResetStatusARB"})
    if ((GetGraphicsResetStatus = reinterpret_cast<decltype(GetGraphicsResetStatus)>(get_proc(name)))) break;
  found.renderer = string_of(GL_RENDERER);
  found.version = string_of(GL_VERSION);
  std::sscanf(found.version.c_str(), "%d.%d", &found.major, &found.minor);
  // Functions are found even where the context does not have them.
  const bool immutable = found.major > 4 || (found.major == 4 && found.minor >= 4) ||
                         (found.major >= 3 && GetStringi && has_extension("GL_ARB_buffer_storage"));
  BufferStorage = immutable ? reinterpret_cast<decltype(BufferStorage)>(get_proc("glBufferStorage")) : nullptr;
  int bits = 0;  // "llvmpipe (LLVM 15.0.6, 256 bits)"
  if (found.renderer.starts_with("llvmpipe"))
    if (const auto comma = found.renderer.rfind(", "); comma != std::string::npos)
      std::sscanf(found.renderer.c_str() + comma, ", %d bits", &bits);
  Device now{.renderer = found.renderer, .version = found.version, .software = is_software(found.renderer)};
  if (found.major > 4 || (found.major == 4 && found.minor >= 3)) {
    found.storage_blocks = now.max_compute_storage_blocks = integer_of(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
    found.invocations = integer_of(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS);
    found.shared_memory = integer_of(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE);
    now.max_texture_buffer_size = integer_of(GL_MAX_TEXTURE_BUFFER_SIZE);
    now.max_storage_bindings = integer_of(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
    now.vector_width = bits / 32;
    now.max_compute_textures = integer_of(GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS);
    GLint64 block_size = 0;
    GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block_size);
    now.max_storage_block_size = block_size;
    GetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &now.max_compute_groups);
    if (!now.software) GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &now.timestamp_bits);
    now.uuid = device_uuid(get_proc);
    now.links_beside =
        has_extension("GL_KHR_parallel_shader_compile") || has_extension("GL_ARB_parallel_shader_compile");
  }
  if (const std::string message = refusal(found); !message.empty()) throw Error(message);
  current_device = now;
  forget_barriers();
}

void require_context() {
  const GLenum status = GetGraphicsResetStatus ? GetGraphicsResetStatus() : GLenum(GL_NO_ERROR);
  if (status == GL_NO_ERROR) return;
  const char* whose = status == GL_GUILTY_CONTEXT_RESET     ? ", caused by this program"
                      : status == GL_INNOCENT_CONTEXT_RESET ? ", caused by another program"
                                                            : "";
  throw ContextLost(current_device.renderer, std::string("the device was reset") + whose + ", and what it held is lost",
                    "expected a device with enough memory that answers in time");
}

void forget_errors() {
  constexpr int kMost = 32;
  for (int i = 0; i < kMost && GetError() != GL_NO_ERROR; ++i) {
  }
}

const Device& device() { return current_device; }

}  // namespace fascia::gl
