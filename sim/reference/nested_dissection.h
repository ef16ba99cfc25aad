// The order in which a mesh's unknowns are eliminated, so that the Cholesky factor stays small: nested dissection
// (George 1973). A plane across the longer sides of what is left parts its vertices in two halves; those of one half
// that have neighbors in the other one are eliminated after both.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fascia::reference {

struct EliminationTree {
  struct Node {
    int begin, end;   // of its vertices in the order, none or more
    int parent = -1;  // comes later in `nodes`; -1: a root
  };
  std::vector<Node> nodes;  // a vertex has neighbors in its own node, below it and above it only
  std::vector<int> place;   // [vertex] in the order
};

/// `neighbors` of each vertex, in both directions; `positions` [vertex].
EliminationTree nested_dissection(const std::vector<std::vector<int>>& neighbors,
                                  const std::vector<Eigen::Vector3d>& positions);

}  // namespace fascia::reference
