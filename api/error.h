// Errors of the library's own rooms become those of the public interface here; every public call goes through it.
#pragma once
#include <utility>

#include "base/error.h"
#include "fascia/error.h"
#include "gl/loader.h"

namespace fascia::api {

/// What `work` returns. Exceptions that are none of ours pass through.
template <class F>
decltype(auto) translated(F&& work) {
  try {
    return std::forward<F>(work)();
  } catch (const gl::ContextLost& error) {
    throw ContextLost(error.what());
  } catch (const fascia::Error& error) {
    throw Error(error.what());
  }
}

}  // namespace fascia::api
