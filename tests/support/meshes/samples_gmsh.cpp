#include "tests/support/meshes/samples.h"

namespace fascia::test {
namespace {

const std::string names = R"($PhysicalNames
4
0 9 "tip"
2 11 "clamp"
3 3 "left part"
3 7 "right"
$EndPhysicalNames
)";

// Node tags are sparse and out of order in every version: 10, 3, 2000000000, 4, 5, 6.
const std::string version_1 = R"($NOD
6
10 0 0 0
3 1 0 0
2000000000 0 1 0
4 0 0 1
5 1 1 1.5
6 9 8 7
$ENDNOD
$ELM
5
1 15 9 1 1 5
2 1 5 1 2 10 3
3 2 11 1 3 10 3 2000000000
4 4 3 1 4 10 3 2000000000 4
5 4 7 2 4 3 2000000000 4 5
$ENDELM
)";

const std::string nodes_2 = R"($Nodes
6
10 0 0 0
3 1 0 0
2000000000 0 1 0
4 0 0 1
5 1 1 1.5
6 9 8 7
$EndNodes
)";

const std::string version_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + nodes_2 + R"($Elements
5
1 15 2 9 1 5
2 1 2 5 1 10 3
3 2 2 11 1 10 3 2000000000
4 4 2 3 1 10 3 2000000000 4
5 4 3 7 2 0 3 2000000000 4 5
$EndElements
$NodeData
1
"a view"
$EndNodeData
)";

const std::string version_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names + R"($Entities
1 1 1 2
1 1 1 1.5 1 9 
1 0 0 0 1 0 0 1 5 2 1 -2 
1 0 0 0 1 1 0 1 -11 1 1 
1 0 0 0 1 1 1 1 3 1 1 
2 0 0 0 1 1 1.5 1 7 1 1 
$EndEntities
$Nodes
3 6 3 2000000000
2 1 1 3
10
3
2000000000
0 0 0 0.5 0.5
1 0 0 0.5 0.5
0 1 0 0.5 0.5
3 1 0 2
4
5
0 0 1
1 1 1.5
3 2 0 1
6
9 8 7
$EndNodes
$Elements
5 5 1 5
0 1 15 1
1 5
1 1 1 1
2 10 3
2 1 2 1
3 10 3 2000000000
3 1 4 1
4 10 3 2000000000 4
3 2 4 1
5 3 2000000000 4 5
$EndElements
)";

std::string binary_2(bool big_endian) {
  Bytes out(big_endian);
  out.add_text("$MeshFormat\n2.2 1 8\n").add(1).add_text("\n$EndMeshFormat\n" + names + "$Nodes\n6\n");
  const TetMesh mesh = sample_mesh();
  const std::vector<int> tags = {10, 3, 2000000000, 4, 5, 6};
  for (std::size_t v = 0; v < 6; ++v) {
    out.add(tags[v]);
    for (int k = 0; k < 3; ++k) out.add(mesh.positions[v][k]);
  }
  out.add_text("\n$EndNodes\n$Elements\n5\n");
  out.add_all<int>({15, 1, 2, 1, 9, 1, 5});
  out.add_all<int>({1, 1, 2, 2, 5, 1, 10, 3});
  out.add_all<int>({2, 1, 2, 3, 11, 1, 10, 3, 2000000000});
  out.add_all<int>({4, 2, 2, 4, 3, 1, 10, 3, 2000000000, 4, 5, 7, 2, 3, 2000000000, 4, 5});
  return out.add_text("\n$EndElements\n").text;
}

template <class Size>
std::string binary_4(bool big_endian) {
  Bytes out(big_endian);
  const auto sizes = [&](const std::vector<Size>& values) { out.add_all(values); };
  const auto ints = [&](const std::vector<int>& values) { out.add_all(values); };
  const auto reals = [&](const std::vector<double>& values) { out.add_all(values); };
  out.add_text("$MeshFormat\n4.1 1 " + std::to_string(sizeof(Size)) + "\n").add(1);
  out.add_text("\n$EndMeshFormat\n" + names + "$Entities\n");
  sizes({1, 1, 1, 2});
  ints({1}), reals({1, 1, 1.5}), sizes({1}), ints({9});
  ints({1}), reals({0, 0, 0, 1, 0, 0}), sizes({1}), ints({5}), sizes({2}), ints({1, -2});
  ints({1}), reals({0, 0, 0, 1, 1, 0}), sizes({1}), ints({-11}), sizes({1}), ints({1});
  ints({1}), reals({0, 0, 0, 1, 1, 1}), sizes({1}), ints({3}), sizes({1}), ints({1});
  ints({2}), reals({0, 0, 0, 1, 1, 1}), sizes({1}), ints({7}), sizes({1}), ints({1});
  out.add_text("\n$EndEntities\n$PartitionedEntities\n");
  sizes({2, 1}), ints({1, 2});  // two partitions, one ghost entity
  sizes({1, 0, 0, 1});
  ints({7, 0, 1}), sizes({1}), ints({1}), reals({1, 1, 1.5}), sizes({0});                        // point 7 of point 1
  ints({8, 3, 2}), sizes({2}), ints({1, 2}), reals({0, 0, 0, 1, 1, 1}), sizes({0}), sizes({0});  // volume 8 of volume 2
  out.add_text("\n$EndPartitionedEntities\n$Nodes\n");
  sizes({3, 6, 3, 2000000000});
  ints({2, 1, 1}), sizes({3}), sizes({10, 3, 2000000000});
  reals({0, 0, 0, .5, .5, 1, 0, 0, .5, .5, 0, 1, 0, .5, .5});
  ints({3, 1, 0}), sizes({2}), sizes({4, 5}), reals({0, 0, 1, 1, 1, 1.5});
  ints({3, 2, 0}), sizes({1}), sizes({6}), reals({9, 8, 7});
  out.add_text("\n$EndNodes\n$Elements\n");
  sizes({5, 5, 1, 5});
  ints({0, 7, 15}), sizes({1, 1, 5});
  ints({1, 1, 1}), sizes({1, 2, 10, 3});
  ints({2, 1, 2}), sizes({1, 3, 10, 3, 2000000000});
  ints({3, 1, 4}), sizes({1, 4, 10, 3, 2000000000, 4});
  ints({3, 8, 4}), sizes({1, 5, 3, 2000000000, 4, 5});
  return out.add_text("\n$EndElements\n").text;
}

}  // namespace

std::vector<MeshSample> gmsh_samples() {
  return {{"Gmsh 1.0 ASCII", "v1.msh", version_1, Keeps::numbers},
          {"Gmsh 2.2 ASCII", "v2.msh", version_2, Keeps::groups},
          {"Gmsh 2.2 ASCII", "crlf.msh",
           [] {
             std::string text;
             for (const char c : version_2) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
             return text;
           }(),
           Keeps::groups},
          {"Gmsh 2.2 binary", "v2_little.msh", binary_2(false), Keeps::groups},
          {"Gmsh 2.2 binary", "v2_big.msh", binary_2(true), Keeps::groups},
          {"Gmsh 4.1 ASCII", "v4.msh", version_4, Keeps::groups},
          {"Gmsh 4.1 binary", "v4_little.msh", binary_4<std::uint64_t>(false), Keeps::groups},
          {"Gmsh 4.1 binary", "v4_big.msh", binary_4<std::uint64_t>(true), Keeps::groups},
          {"Gmsh 4.1 binary", "v4_small.msh", binary_4<std::uint32_t>(false), Keeps::groups}};
}

}  // namespace fascia::test
