// What every public header begins with: which names the library shows, and the namespace.
//
// The public types live in fascia::api, an inline namespace: programs write fascia::Simulation, and links and messages
// show fascia::api::Simulation. The library's own sources have internal types of the same names directly in fascia;
// FASCIA_BUILD, which only they define, makes the namespace an ordinary one for them. The names of the symbols are the
// same either way.
#pragma once
#include <array>

#define FASCIA_EXPORT __attribute__((visibility("default")))
#define FASCIA_HIDDEN __attribute__((visibility("hidden")))  // what an exported class has for the library alone
#ifdef FASCIA_BUILD
#define FASCIA_INLINE
#else
#define FASCIA_INLINE inline
#endif

namespace fascia {
FASCIA_INLINE namespace api {
  using Vec3 = std::array<double, 3>;  // x, y, z

}  // namespace api
}  // namespace fascia
