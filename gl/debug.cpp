#include "gl/debug.h"

#include <utility>

#include "gl/loader.h"

namespace fascia::gl {
namespace {

std::function<void(const std::string&)> current_sink;

const char* severity_name(GLenum severity) {
  switch (severity) {
    case GL_DEBUG_SEVERITY_HIGH:
      return "high";
    case GL_DEBUG_SEVERITY_MEDIUM:
      return "medium";
    default:
      return "low";
  }
}

void APIENTRY forward(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* message,
                      const void*) {
  if (!current_sink) return;
  std::string text(message, static_cast<std::size_t>(length));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  for (char& c : text)
    if (c == '\n') c = ' ';
  current_sink(std::string("OpenGL ") + (type == GL_DEBUG_TYPE_ERROR ? "error " : "message ") + std::to_string(id) +
               " (" + severity_name(severity) + "): " + text);
}

}  // namespace

void log_debug_messages(std::function<void(const std::string&)> sink) {
  current_sink = std::move(sink);
  Enable(GL_DEBUG_OUTPUT);
  Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
  DebugMessageCallback(forward, nullptr);
}

}  // namespace fascia::gl
