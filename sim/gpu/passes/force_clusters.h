// Forces of tets, summed within work groups. A cluster is the pairs and single tets that one work group processes. Its
// tets share most of their vertices, so that it stores one force for each of its vertices instead of five for each
// pair: shared memory holds the others (shaders/common/cluster.glsl). For GPUs: software renderers have no fast shared
// memory.
#pragma once
#include <cstdint>
#include <vector>

#include "gl/program.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

class ForceClusters {
 public:
  static constexpr std::uint32_t kPairs = 64;  // of a cluster, GROUP_SIZE of shaders/common/io.glsl

  /// Whether passes over `buffers` sum in clusters.
  static bool serve(const gl::ProgramCache& programs, const SimBuffers& buffers);
  /// In the current order of the tets.
  explicit ForceClusters(const SimBuffers& buffers);

  std::uint32_t count() const { return count_of(pairs_); }
  static std::uint32_t count_of(std::uint32_t pairs) { return (pairs + kPairs - 1) / kPairs; }
  const gl::Buffer& lists() const { return lists_; }            // uint, as shaders/common/cluster.glsl states them
  const gl::Buffer& forces() const { return forces_; }          // vec4 [slots], sorted by vertex
  const gl::Buffer& slot_begin() const { return slot_begin_; }  // uint [vertex_count + 1]

 private:
  std::uint32_t pairs_;  // and single tets
  gl::Buffer lists_, forces_, slot_begin_;
};

/// Of an item list of pairs in ascending order: for each cluster that has any of them its number and, in two numbers,
/// a bit for each of its pairs.
std::vector<std::uint32_t> clusters_of(const std::vector<std::uint32_t>& pairs);

}  // namespace fascia
