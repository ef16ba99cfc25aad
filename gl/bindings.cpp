#include "gl/bindings.h"

#include <algorithm>
#include <map>
#include <vector>

namespace fascia::gl {
namespace {

int scopes = 0;
std::uint64_t bindings = 0;
std::map<GLuint, GLuint> bound;  // point -> buffer, within a scope

}  // namespace

GLuint binding_point(const std::string& block, std::set<GLuint>& taken) {
  static std::map<std::string, GLuint> points;  // of names
  static std::vector<std::uint64_t> asked;      // [point] when one of its names was last asked for
  static std::uint64_t now = 0;
  asked.resize(static_cast<std::size_t>(device().max_storage_bindings));
  const auto [of_block, is_new] = points.emplace(block, 0);
  if (is_new || of_block->second >= asked.size())
    of_block->second = static_cast<GLuint>(std::min_element(asked.begin(), asked.end()) - asked.begin());
  GLuint point = of_block->second;
  asked[point] = ++now;
  while (!taken.insert(point).second) point = (point + 1) % static_cast<GLuint>(asked.size());
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
