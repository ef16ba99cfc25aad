// The namespace, the visibility of symbols and the vector type of all public headers.
//
// The public types live in fascia::api, an inline namespace: programs write fascia::Simulation, and the messages of
// linkers and debuggers show fascia::api::Simulation. The library's own sources have internal types of the same names
// directly in fascia. They define FASCIA_BUILD, which makes the namespace an ordinary one. The names of the symbols are
// the same in both cases.
#pragma once
#include <array>

#define FASCIA_EXPORT __attribute__((visibility("default")))
#define FASCIA_HIDDEN __attribute__((visibility("hidden")))  // members of an exported class for the library alone
#ifdef FASCIA_BUILD
#define FASCIA_INLINE
#else
#define FASCIA_INLINE inline
#endif

namespace fascia {
FASCIA_INLINE namespace api {
  using Vec3 = std::array<double, 3>;  // Three components: x, y, z. The unit is stated where the type is used.

}  // namespace api
}  // namespace fascia
