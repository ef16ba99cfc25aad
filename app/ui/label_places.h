// Places labels inside the picture, without overlap with each other and with other content.
#pragma once
#include <vector>

namespace fascia {

/// A rectangle in a picture, y down.
struct Box {
  float left = 0, top = 0, right = 0, bottom = 0;
  bool operator==(const Box&) const = default;
};

class LabelPlaces {
 public:
  /// `gap`: distance between labels and all other boxes.
  LabelPlaces(const Box& picture, float gap) : picture_(picture), gap_(gap) {}

  void keep_clear(const Box& box) {
    taken_.push_back({box.left - gap_, box.top - gap_, box.right + gap_, box.bottom + gap_});
  }
  /// Reserves and returns the free place for a label that is nearest to `wanted`; if there is none, the place that
  /// hides least.
  Box place(const Box& wanted);

 private:
  float hidden(const Box& label) const;  // overlap of the label with reserved areas

  Box picture_;
  float gap_;
  std::vector<Box> taken_;
};

}  // namespace fascia
