// The pairs of the tissue in a stage (sim/contact/pair_search.h), found from the state that the GPU has.
#pragma once
#include <vector>

#include "sim/contact/pair_search.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

class PairStage {
 public:
  /// Empty if no tissue of the model touches tissue. `model` outlives this object.
  explicit PairStage(const Model& model);
  void materials_changed(const Model& model, std::span<ContactForce> memory);

  bool empty() const { return search_.empty(); }
  std::uint32_t slot_count() const { return search_.slot_count(); }  // at most so many pairs
  std::uint32_t row_count() const { return search_.row_count(); }    // of the memory of contact

  /// Finds the pairs of a stage that ends at `time` [s]. Forces without a pair are forgotten, in the rows
  /// of the memory of contact from `first_row` on. Waits for the GPU.
  void begin(double time, const IntegratorStage& stage, SimBuffers& buffers, std::uint32_t first_row);
  /// If the iterations led tissue through tissue, finds the pairs that are met on the way to their result. Waits for
  /// the GPU where tissue is near tissue.
  bool search_again(SimBuffers& buffers, std::uint32_t first_row);
  /// After the last search: if the result still leads tissue through tissue, takes the bodies that meet so back. Waits
  /// for the GPU where tissue is near tissue.
  void take_back(SimBuffers& buffers);
  void state_changed() { is_taken_back_ = false; }
  bool cuts() const { return search_.cuts(); }
  long taken_back() const { return taken_back_; }  // in how many stages so far

  const std::vector<PairRow>& rows() const { return rows_; }
  const std::vector<Eigen::Vector3d>& start() const { return start_; }  // [vertex] u as the stage began [m]
  double search_ms() const { return search_ms_; }  // that all searches so far took, without waiting for the GPU
  /// Lowers the shares [body] of the way to where velocities lead to those at which the body meets another, or itself.
  /// Bodies that press each other, or meet, go together: `leaders` [body] gets the first body of each such group, whose
  /// share is that of all.
  void limit(std::vector<float>& shares, std::vector<std::uint32_t>& leaders) const;
  bool parts() const;  // whether bodies begin the stage nearer to each other than they are to end it
  /// What other tissue did to a body at the end of the stage before.
  struct Support {
    Eigen::Vector3d force{0, 0, 0};  // [N]
    Eigen::Vector3d way{0, 0, 0};    // sum of those on which the velocities of its places that pressed lead [m]
    std::uint32_t count = 0;         // of such places
  };
  std::vector<Support> supports(std::size_t body_count) const;  // [body]
  double duration() const { return duration_; }                 // of the stage [s]

 private:
  template <class F>
  auto timed(F&& search);
  void find(SimBuffers& buffers, std::uint32_t first_row);
  void upload_forces(SimBuffers& buffers, std::uint32_t first_row) const;

  const Model& model_;  // its materials may change
  PairSearch search_;
  double search_ms_ = 0, start_time_ = 0, duration_ = 0, length_ = 0;
  long taken_back_ = 0;
  bool is_taken_back_ = false, was_taken_back_ = false;  // this stage, and the one before
  std::vector<PairRow> rows_;
  std::vector<shared::vec4> before_;  // [row] that the step before left: of forces xyz friction, w the normal one [N]
  std::vector<char> falls_;           // [vertex] in unconstrained parts
  std::vector<Eigen::Vector3d> start_, end_;  // [vertex] u at the start, and where the pairs are looked for up to [m]
};

}  // namespace fascia
