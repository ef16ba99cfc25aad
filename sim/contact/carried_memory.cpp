#include "sim/contact/carried_memory.h"

#include <algorithm>

#include "sim/contact/contact_surface.h"

namespace fascia {

ContactMemory carried_memory(const Model& before, const ContactMemory& memory, const Model& after) {
  const ContactSurface from = make_contact_surface(before), to = make_contact_surface(after);
  if (before.rest_positions != after.rest_positions || before.tets != after.tets || before.held() != after.held() ||
      memory.size() < from.row_count)
    return {};
  const std::ptrdiff_t of_tissue = static_cast<std::ptrdiff_t>(memory.size()) - from.row_count;
  ContactMemory carried(to.row_count + static_cast<std::size_t>(of_tissue));
  std::copy_n(memory.end() - of_tissue, of_tissue, carried.begin() + to.row_count);
  for (const ContactPiece& piece : to.pieces)
    for (const ContactPiece& same : from.pieces)
      if (before.tools[same.tool].name == after.tools[piece.tool].name && same.piece == piece.piece &&
          same.points == piece.points)
        std::copy_n(memory.begin() + same.first_row, piece.points, carried.begin() + piece.first_row);
  return carried;
}

}  // namespace fascia
