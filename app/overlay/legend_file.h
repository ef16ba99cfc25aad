// The legend of a picture as a file of its own, for documents whose text has another font and size.
#pragma once
#include <filesystem>

#include "app/session/session.h"

namespace fascia {

/// Whether the colors of the session's picture have a meaning, also where the scene key "display.legend" hides it.
bool has_legend_file(const Session& session);

/// Writes the color bar or the names of the regions of the picture drawn last, as SVG or PDF by the ending of `path`:
/// black on no background. Uses gnuplot. Throws Error.
void write_legend(const std::filesystem::path& path, const Session& session);

}  // namespace fascia
