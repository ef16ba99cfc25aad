// Creates contexts of all kinds: those without a window (gl/context), and the window.
#pragma once
#include "gl/context/context.h"

namespace fascia {

/// The context is current and loaded (gl::load). Throws Error with the attempts and the reason of each failure, or with
/// the missing compute support.
std::unique_ptr<Context> make_context(const ContextRequest& request);

/// With a device of the request, drawn by that device if the display permits it; else Context::other_device says so.
/// Throws Error without a display, or without such a device.
std::unique_ptr<Context> make_window_context(const ContextRequest& request);

}  // namespace fascia
