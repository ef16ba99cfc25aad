#include "app/ui/label_places.h"

#include <algorithm>
#include <cmath>

namespace fascia {

float LabelPlaces::hidden(const Box& label) const {
  constexpr float kTouching = 0.01f;  // rounding of float32 for edges that touch
  float sum = 0;
  for (const Box& box : taken_) {
    const float width = std::min(label.right, box.right) - std::max(label.left, box.left);
    const float height = std::min(label.bottom, box.bottom) - std::max(label.top, box.top);
    if (width > kTouching && height > kTouching) sum += width * height;
  }
  return sum;
}

Box LabelPlaces::place(const Box& wanted) {
  const float width = wanted.right - wanted.left, height = wanted.bottom - wanted.top;
  const auto inside = [&](float left, float top) {
    left = std::max(picture_.left, std::min(left, picture_.right - width));
    top = std::max(picture_.top, std::min(top, picture_.bottom - height));
    return Box{left, top, left + width, top + height};
  };
  const auto take = [&](const Box& box) {
    keep_clear(box);
    return box;
  };
  Box best = inside(wanted.left, wanted.top);
  float least = hidden(best), nearest = std::hypot(best.left - wanted.left, best.top - wanted.top);
  if (least == 0) return take(best);
  // Candidates are the edges of the boxes that overlap.
  std::vector<float> lefts{wanted.left}, tops{wanted.top};
  for (const Box& box : taken_) {
    lefts.insert(lefts.end(), {box.left - width, box.right});
    tops.insert(tops.end(), {box.top - height, box.bottom});
  }
  for (const float left : lefts)
    for (const float top : tops) {
      const Box box = inside(left, top);
      const float covers = hidden(box), distance = std::hypot(box.left - wanted.left, box.top - wanted.top);
      if (covers < least || (covers == least && distance < nearest)) {
        best = box;
        least = covers;
        nearest = distance;
      }
    }
  return take(best);
}

}  // namespace fascia
