#include "tests/support/meshes/samples.h"

namespace fascia::test {
namespace {

const std::string medit = R"(MeshVersionFormatted 2
# a comment
Dimension
3
Vertices
6
0 0 0 1
1 0 0 1
0 1 0 1
0 0 1 0
1 1 1.5 0
9 8 7 0
Corners
2
1 2
Edges
1
1 2 5
Triangles
1
1 2 3 11
SomethingNew
2
0.5 -1e-3
Tetrahedra 2
1 2 3 4 3
2 3 4 5 7
End
)";

const std::string node_1 = R"(# Node count, 3 dim, 1 attribute, boundary markers
  6  3  1  1

   1    0 0 0    0.5  1
   2    1 0 0    0.5  1
   3    0 1 0    0.5  1  # a comment
   4    0 0 1    0.5  0
   5    1 1 1.5  0.5  0
   6    9 8 7    0.5  0
# Generated
)";
const std::string ele_1 = R"(2  4  2
   1   1 2 3 4   3  0.25
   2   2 3 4 5   7  0.25
# Generated
)";
const std::string node_0 = "6 3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 1 1 1.5\n5 9 8 7\n";
const std::string ele_0 = "2 4 0\n0 0 1 2 3\n1 1 2 3 4\n";
const std::string ele_10 = "2 10 1\n0 0 1 2 3 5 5 5 5 5 5 3\n1 1 2 3 4 5 5 5 5 5 5 7\n";

}  // namespace

std::vector<MeshSample> other_samples() {
  return {{"Medit ASCII", "medit.mesh", medit},
          {"TetGen .node/.ele", "one.ele", ele_1, Keeps::regions, node_1},
          {"TetGen .node/.ele", "zero.ele", ele_0, Keeps::tets, node_0},
          {"TetGen .node/.ele", "ten.ele", ele_10, Keeps::regions, node_0}};
}

}  // namespace fascia::test
