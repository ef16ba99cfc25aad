#include "gl/bindings.h"

#include <map>

namespace fascia::gl {
namespace {

int scopes = 0;
std::uint64_t bindings = 0;
std::map<GLuint, GLuint> bound;  // point -> buffer, within a scope

}  // namespace

GLuint binding_point(const std::string& block, std::set<GLuint>& taken) {
  static std::map<std::string, GLuint> numbers;  // in the order in which the names came up
  const auto points = static_cast<GLuint>(device().max_storage_bindings);
  GLuint point = numbers.emplace(block, static_cast<GLuint>(numbers.size())).first->second % points;
  while (!taken.insert(point).second) point = (point + 1) % points;
  return point;
}

void bind_storage(GLuint point, GLuint buffer) {
  if (scopes > 0) {
    GLuint& now = bound[point];
    if (now == buffer) return;
    now = buffer;
  }
  BindBufferBase(GL_SHADER_STORAGE_BUFFER, point, buffer);
  ++bindings;
}

void forget_bindings_of(GLuint buffer) {
  std::erase_if(bound, [&](const auto& binding) { return binding.second == buffer; });
}

std::uint64_t binding_count() { return bindings; }

KeptBindings::KeptBindings() { ++scopes; }
KeptBindings::~KeptBindings() {
  if (--scopes == 0) bound.clear();
}

}  // namespace fascia::gl
