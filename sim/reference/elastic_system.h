// All tets of a Model together: total elastic energy, its gradient over every vertex, and its Hessian over the free
// ones as a sparse matrix. The sparsity pattern is found once, in an elimination order that keeps the Cholesky factor
// small, and tets then add directly to the stored values.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <vector>

#include "sim/model/model.h"
#include "sim/reference/elasticity.h"
#include "sim/reference/factor/cholesky.h"

namespace fascia::reference {

/// Viscous part of a stage (elasticity.h, sim/integrators/stage.h). Empty: purely elastic.
struct ViscousStep {
  std::vector<Eigen::Matrix3d> previous_strain;  // eps*, from ElasticSystem::strains()
  double h = 1;                                  // l [s]
};

class ElasticSystem {
 public:
  explicit ElasticSystem(const Model& model);

  int dof_count() const { return dof_count_; }
  /// First of the three unknowns of each vertex, or -1 if it is constrained or in no tet.
  const std::vector<int>& first_dof() const { return first_dof_; }
  /// The entries of free vertices, in the order of the unknowns.
  Eigen::VectorXd free_part(const Eigen::VectorXd& all) const;
  void add_to_free(const Eigen::VectorXd& free, double factor, Eigen::VectorXd& all) const;

  /// Energy [J] at displacements `u` [3 * vertex_count], and its gradient [N] over all vertices, including constrained
  /// ones. `rounded` receives what the energy's rounding has beside that of u, over the machine epsilon [J]: the work
  /// of the tets' forces on reach().
  double evaluate(const Eigen::VectorXd& u, const ViscousStep& viscous, Eigen::VectorXd& gradient,
                  double* rounded = nullptr) const;
  /// Upper triangle of the Hessian [N/m] over the unknowns into `hessian` (from empty_hessian()). `scale` [3 *
  /// vertex_count] receives sum_e |H_e| (|u| + reach()): times the machine epsilon it bounds the rounding of the
  /// gradient.
  void assemble(const Eigen::VectorXd& u, const ViscousStep& viscous, bool project, SparseMatrix& hessian,
                Eigen::VectorXd& scale) const;
  /// Adds a block to the Hessian's rows of one vertex and columns of another, both of one tet, unless it lies below the
  /// diagonal or at a constrained vertex.
  void add_block(std::uint32_t row_vertex, std::uint32_t column_vertex, const Eigen::Matrix3d& block,
                 SparseMatrix& hessian) const;
  /// Hessian over all vertices times `direction` [3 * vertex_count].
  Eigen::VectorXd hessian_times(const Eigen::VectorXd& u, const ViscousStep& viscous,
                                const Eigen::VectorXd& direction) const;
  const SparseMatrix& empty_hessian() const { return pattern_; }
  const EliminationTree& elimination_tree() const { return tree_; }  // of the free vertices, three unknowns each

  double largest_coordinate() const;                                     // of a rest position [m]
  bool viscous() const;                                                  // whether any material has damping
  std::vector<Eigen::Matrix3d> strains(const Eigen::VectorXd& u) const;  // Green strain: one per linear tet, four per
                                                                         // quadratic one, at its points
  double min_det_f(const Eigen::VectorXd& u) const;                      // at the points

 private:
  /// Displacement [m] whose rounding is that of the sum F = I + grad u, at vertex `a` of a tet; 0 for laws of strain.
  Eigen::Vector3d reach(std::size_t t, const ElementVertices& element, int a) const;
  void make_pattern(const std::vector<std::vector<int>>& rows);  // ascending row blocks of every block column
  /// Calls f(number of the tet, its vertices, its derivatives) for every tet whose vertices `wanted` accepts.
  template <class Wanted, class F>
  void visit(const Eigen::VectorXd& u, const ViscousStep& viscous, bool with_hessian, bool project, Wanted&& wanted,
             F&& f) const;

  const Model& model_;
  std::vector<LinearTet> rest_;           // of quadratic tets that of the corners
  std::vector<std::size_t> first_point_;  // [tet_count] into ViscousStep::previous_strain
  std::vector<int> first_dof_;
  int dof_count_ = 0;
  EliminationTree tree_;
  SparseMatrix pattern_;  // zeros
  // Where tets add: for n vertices of a tet, [n * row vertex + column vertex] from its first_block_. The three columns
  // of a block column store their blocks in the same order, so one rank gives the start of the 3x3 block in each of
  // them. -1: not stored.
  std::vector<int> block_rank_;
  std::vector<std::size_t> first_block_;  // [tet_count]
};

/// Vectors of all vertices as one vector of components [3 * vertex_count], and back.
Eigen::VectorXd flattened(const std::vector<Eigen::Vector3d>& vectors);
std::vector<Eigen::Vector3d> as_vectors(const Eigen::VectorXd& all);

}  // namespace fascia::reference
