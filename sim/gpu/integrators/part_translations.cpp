#include "sim/gpu/integrators/part_translations.h"

#include <algorithm>

#include "sim/gpu/passes/reduction.h"

namespace fascia {

PartTranslations::PartTranslations(const UnconstrainedParts& parts) {
  if (parts.parts == 0) return;
  std::vector<std::vector<std::uint32_t>> of_part(parts.parts);
  for (std::uint32_t v = 0; v < parts.part.size(); ++v)
    if (parts.part[v] > 0) of_part[parts.part[v] - 1].push_back(v);
  std::vector<std::uint32_t> vertices, begins, chunks;
  for (const std::vector<std::uint32_t>& part : of_part) {
    const auto first = static_cast<std::uint32_t>(begins.size()), count = static_cast<std::uint32_t>(part.size()),
               own = (count + kChunk - 1) / kChunk;
    for (std::uint32_t k = 0; k < own; ++k) begins.push_back(static_cast<std::uint32_t>(vertices.size()) + k * kChunk);
    vertices.insert(vertices.end(), part.begin(), part.end());
    for (std::uint32_t k = 0; k < count; ++k) chunks.insert(chunks.end(), {first, first + own});
    most_chunks_ = std::max(most_chunks_, own);
  }
  vertex_count_ = static_cast<std::uint32_t>(vertices.size());
  chunk_count_ = static_cast<std::uint32_t>(begins.size());
  begins.push_back(vertex_count_);
  vertices_ = gl::Buffer("part_vertex", vertices);
  chunk_begin_ = gl::Buffer("chunk_begin", begins);
  chunks_ = gl::Buffer("part_chunks", chunks);
  sums_ = gl::Buffer("part_sums", chunk_count_ * sizeof(shared::vec4));
}

Passes PartTranslations::passes(const Recording& r) const {
  Passes passes;
  const std::uint32_t lanes = r.programs.sums_in_groups() ? Reduction::kGroup : 1;
  passes
      .emplace_back(r.programs.compute("sim/step/part_sums.comp"),
                    gl::ComputePass::Bindings{{"part_vertex", &vertices_},
                                              {"chunk_begin", &chunk_begin_},
                                              {"displacement", &r.buffers.displacement},
                                              {"predicted", &r.buffers.predicted},
                                              {"mass", &r.buffers.mass},
                                              {"part_sums", &sums_}},
                    lanes * chunk_count_)
      .loops(kChunk / lanes + 1);
  passes
      .emplace_back(r.programs.compute("sim/step/part_translation.comp"),
                    gl::ComputePass::Bindings{{"part_vertex", &vertices_},
                                              {"part_chunks", &chunks_},
                                              {"part_sums", &sums_},
                                              {"displacement", &r.buffers.displacement}},
                    vertex_count_)
      .loops(most_chunks_ + 1);
  return passes;
}

}  // namespace fascia
