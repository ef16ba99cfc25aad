// Numbers about the state, computed on the GPU and read without waiting: residual, energies, momentum, J, volume,
// strain, stress, grab force, the displacement of one vertex.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gl/compute_pass.h"
#include "gl/fence.h"
#include "sim/gpu/contact/contact_term.h"
#include "sim/gpu/passes/features.h"
#include "sim/gpu/passes/grab_springs.h"

namespace fascia {

struct Diagnostics {
  /// |g| / (|M (u - u~)| + |h^2 f| + |h^2 loads|) with g = M (u - u~) - h^2 f over free vertices: 0 is solved, 1 is
  /// nothing solved. Zero when all forces are below the rounding of the motion itself.
  double residual = 0;
  double time = 0;                                               // simulated time of the measured state [s]
  double kinetic = 0, elastic = 0, gravitational = 0;            // [J]; gravitational: 0 at the rest positions
  double volume_ratio = 1;                                       // of all tets together, over their volume at rest
  Eigen::Vector3d momentum{0, 0, 0}, angular_momentum{0, 0, 0};  // [kg m/s], [kg m^2/s]
  Eigen::Vector3d reaction{0, 0, 0};                             // of the supports on the body [N]
  Eigen::Vector3d grab_force{0, 0, 0};                           // of all grabs on the body [N]
  std::vector<GrabForce> grab_forces;                            // of each of them
  Eigen::Vector3d inertia{0, 0, 0};                              // mass times acceleration, of free vertices [N]
  /// reaction + grab_force + tool_force + `weight` - inertia over the largest of them, of a single grab or tool, or
  /// `of_support`, the largest force of a single support [N], those of several may cancel [-]: zero where the last step
  /// is solved, since internal forces cancel. The weight is that of the whole scene [N]. 0 where there are no forces
  /// beyond rounding.
  double imbalance(const Eigen::Vector3d& weight, double of_support = 0) const;
  double force_rounding = 0;  // [N] upper bound of the inertia's rounding in float32
  double min_det_f = 1, max_det_f = 1, max_strain = 0, max_von_mises = 0, max_speed = 0;  // [-], [-], [-], [Pa], [m/s]
  double rms_strain = 0;  // root of the mean of |strain|^2 (Frobenius) over the volume
  int inverted = 0;
  std::optional<int> iterations;         // of the last substep, where solver.tolerance ends them
  std::optional<Eigen::Vector3d> probe;  // displacement of the vertex of set_probe [m]
  std::vector<ToolLoad> tool_loads;      // of each tool of the model, over the step (sim/contact/step_loads.h)
  std::vector<PairLoad> pair_loads;      // of tissue that touches tissue, the same
  Eigen::Vector3d tool_force{0, 0, 0};   // of all tools on the body at the end of the step, as the other sums [N]
  bool finite = true;

  /// tool_loads and pair_loads, and tool_force from those at the end of the step.
  void set_loads(ContactLoads of_step, const ContactLoads& at_end);
};

class DiagnosticsReader {
 public:
  explicit DiagnosticsReader(const SimBuffers& buffers);
  DiagnosticsReader(const DiagnosticsReader&) = delete;
  DiagnosticsReader& operator=(const DiagnosticsReader&) = delete;
  void record(gl::ProgramCache& programs, const SimBuffers& buffers, const Features& features,
              const gl::Buffer& previous_strain, const EnergyTerms& terms);
  /// A vertex whose displacement is read together with the sums; none: no vertex.
  void set_probe(std::optional<std::uint32_t> vertex) { probe_ = vertex; }
  /// Dispatches the sums over the current state, of `time` [s], and queues their copy. `substep` h [s]. `stop_state`:
  /// of a StopRule, or null. `contact` outlives the request. `has_step`: whether the state is the end of a step, whose
  /// accelerations then count in the reaction.
  void request(const GrabSprings& grab, const ContactTerm& contact, double substep, double time,
               const gl::Buffer* stop_state, bool has_step);
  bool pending() const {
    return pending_[0].fence.is_set() || pending_[1].fence.is_set();
  }  // a request whose result was not taken yet
  /// The newest finished result that was not taken yet, if any. With `wait`, the last request's.
  std::optional<Diagnostics> take(bool wait);

 private:
  struct Pending {
    gl::Buffer staging;
    gl::Fence fence;
    GrabSprings::Owners owners;
    double substep = 0, time = 0, mean_mass = 0;
    bool counts_iterations = false, has_probe = false;
    const ContactTerm* contact = nullptr;  // null: nothing is touched
    std::vector<PairRow> pairs;
    StepLoads earlier;  // of the stages of the step before the last one
  };
  Diagnostics sum_up(const Pending& pending) const;

  std::uint32_t pair_partial_count_, quadratic_partial_count_, vertex_partial_count_;
  bool leaves_out_;          // whether tets that stay at rest are left out
  double volume_;            // of all tets [m^3]
  const double& mean_mass_;  // [kg] follows the materials
  const gl::Buffer& displacement_;
  std::optional<std::uint32_t> probe_;
  gl::Buffer tet_partials_, vertex_partials_;
  gl::Buffer centroid_partials_;  // of quadratic tets
  std::vector<gl::ComputePass> passes_;
  std::array<Pending, 2> pending_;
  unsigned newest_ = 0;
  std::uint32_t has_step_ = 0;  // of the last request
};

}  // namespace fascia
