// Follows the buffers of a context through OpenGL's calls and finds accesses that no barrier orders: reads of what a
// shader has stored, and stores over what shaders have accessed (OpenGL 4.3, 7.12.2). It knows the calls, what the
// driver states of linked programs, and the declarations in their text; nothing of gl/barriers.h, which it judges.
// One at a time, from before the first buffer on.
#pragma once
#include <memory>
#include <set>
#include <string>

#include "gl/loader.h"

namespace fascia::test {

class BarrierWatch {
 public:
  /// `left_out`: bits that the watch takes every barrier not to have.
  explicit BarrierWatch(GLbitfield left_out = 0);
  ~BarrierWatch();
  BarrierWatch(const BarrierWatch&) = delete;
  BarrierWatch& operator=(const BarrierWatch&) = delete;

  /// "sim/step/velocity.comp: Displacement (displacement) needs GL_... after sim/step/predict.comp", each once.
  const std::set<std::string>& findings() const;
  /// The bits of all barriers.
  GLbitfield bits() const;
  long barriers() const;
  long commands() const;  // dispatches and draws
  /// Bits of barriers that no access needed before the next barrier with the same bit.
  long needless_bits() const;

 private:
  struct Hooks;
  std::unique_ptr<Hooks> hooks_;
};

}  // namespace fascia::test
