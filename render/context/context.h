// All kinds of contexts: those without a window (gl/context), and the window.
#pragma once
#include "gl/context/context.h"

namespace fascia {

/// Made current and loaded (gl::load). Throws Error with what was tried and why each failed, or what compute
/// support is missing.
std::unique_ptr<Context> make_context(const ContextRequest& request);

/// Throws Error without a display.
std::unique_ptr<Context> make_window_context(const ContextRequest& request);

}  // namespace fascia
