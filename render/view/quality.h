// Effects of a picture that cost time and show nothing new. An effect that is off is absent from the shaders.
#pragma once

namespace fascia {

struct Quality {
  bool detail = false;          // patches, bumps and reflections on tissue
  bool contact_shadow = false;  // shadows on tissue sharpen toward the caster; otherwise their edge has one width
  bool edge_smoothing = false;  // smooths edges where a pixel has one sample
  int shadow_taps = 5;          // lookups per pixel in the shadow map, without contact_shadow
  int shadow_every = 1;         // pictures drawn with one shadow map, which then lags behind the tissue
  bool operator==(const Quality&) const = default;
};

inline constexpr Quality kDraftQuality{}, kFullQuality{true, true, true};

}  // namespace fascia
