// Converts errors of the library's internals to those of the public interface; every public call passes through it.
#pragma once
#include <utility>

#include "base/error.h"
#include "fascia/error.h"
#include "gl/loader.h"

namespace fascia::api {

/// Returns the result of `work`. Exceptions of other libraries pass through.
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
