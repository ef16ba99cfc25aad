// The order in which a mesh's unknowns are eliminated, so that the Cholesky factor stays small: nested dissection
// (George 1973). A plane perpendicular to the longest side of the remaining part splits its vertices in two halves; the
// vertices of one half with neighbors in the other are eliminated after both.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fascia::reference {

struct EliminationTree {
  struct Node {
    int begin, end;   // of its vertices in the order; may be empty
    int parent = -1;  // after this node in `nodes`; -1: a root
  };
  std::vector<Node> nodes;  // a vertex has neighbors only in its own node, below and above it
  std::vector<int> place;   // [vertex] position in the order
};

/// `neighbors` of each vertex, in both directions; `positions` [vertex].
EliminationTree nested_dissection(const std::vector<std::vector<int>>& neighbors,
                                  const std::vector<Eigen::Vector3d>& positions);

}  // namespace fascia::reference
