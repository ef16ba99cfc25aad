// Tables index,x,y,z: valid content, and the line that each error reports.
#include "sim/model/vertex_csv.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::string error_of(const std::string& text, std::size_t vertex_count = 8) {
  const SceneFile file(text, "t.csv");
  return file.error_of([&] { read_vertex_csv(file.path(), vertex_count); });
}

}  // namespace

TEST_CASE("rows in any order, with or without a header, with spaces and either line ending") {
  for (const std::string text : {"index,x,y,z\n5,1,2,3\n0,-1e-3,.5,+0.25\n", "5,1,2,3\n0,-1e-3,.5,+0.25",
                                 "\"index\",\"vx\",\"vy\",\"vz\"\r\n\r\n 5 , 1,\t2 ,3\r\n0,-1e-3,.5,+0.25\r\n\r\n"}) {
    CAPTURE(text);
    const SceneFile file(text, "t.csv");
    const VertexTable table = read_vertex_csv(file.path(), 8);
    CHECK(table.vertices == std::vector<std::uint32_t>{0, 5});
    CHECK(table.values == std::vector<Eigen::Vector3d>{{-1e-3, 0.5, 0.25}, {1, 2, 3}});
  }
}

TEST_CASE("numbers are read to the last bit") {
  const SceneFile file("0,0.30000000000000004,-0.050000000000000003,4.9406564584124654e-324\n", "t.csv");
  CHECK(read_vertex_csv(file.path(), 1).values[0] ==
        Eigen::Vector3d(0.1 + 0.2, -0.05, std::numeric_limits<double>::denorm_min()));
}

TEST_CASE("each error in a table has its line") {
  CHECK(error_of("index,x,y,z\n0,1,2\n") == "t.csv:2: \"0,1,2\" does not have 4 fields; expected index,x,y,z");
  CHECK(error_of("0,1,2,3\n\n1,1,2,3,4\n") == "t.csv:3: \"1,1,2,3,4\" does not have 4 fields; expected index,x,y,z");
  CHECK(error_of("0 1 2 3\n") == "t.csv:1: \"0 1 2 3\" does not have 4 fields; expected index,x,y,z");
  CHECK(error_of("0,1,2,3\n8,1,2,3\n") == "t.csv:2: vertex 8 does not exist; expected 0 to 7");
  CHECK(error_of("0,1,2,3\n-1,1,2,3\n") == "t.csv:2: vertex -1 does not exist; expected 0 to 7");
  CHECK(error_of("4294967296,1,2,3\n") == "t.csv:1: vertex 4294967296 does not exist; expected 0 to 7");
  CHECK(error_of("1.5,1,2,3\n") == "t.csv:1: \"1.5\" is not a vertex index; expected index,x,y,z");
  CHECK(error_of("99999999999999999999,1,2,3\n") ==
        "t.csv:1: \"99999999999999999999\" is not a vertex index; expected index,x,y,z");
  CHECK(error_of("0,1,2,3\nindex,x,y,z\n") == "t.csv:2: \"index\" is not a vertex index; expected index,x,y,z");
  CHECK(error_of("O,1,2,3\n") == "t.csv:1: \"O\" is not a vertex index; expected index,x,y,z");
  CHECK(error_of("0,nan,2,3\n") == "t.csv:1: x is \"nan\"; expected a finite number");
  CHECK(error_of("0,1,-inf,3\n") == "t.csv:1: y is \"-inf\"; expected a finite number");
  CHECK(error_of("0,1,2,1e999\n") == "t.csv:1: z is \"1e999\"; expected a finite number");
  CHECK(error_of("0,1,2,\n") == "t.csv:1: z is \"\"; expected a finite number");
  CHECK(error_of("0,1,2,3m\n") == "t.csv:1: z is \"3m\"; expected a finite number");
  CHECK(error_of("3,1,2,3\n5,1,2,3\n\n3,0,0,0\n") ==
        "t.csv:4: vertex 3 stands on line 1 already; expected each vertex once");
  CHECK(error_of("") == "t.csv: has no rows; expected lines index,x,y,z");
  CHECK(error_of("index,x,y,z\n") == "t.csv: has no rows; expected lines index,x,y,z");
  CHECK(error_of(std::string("\0\1\2\n", 4)) == "t.csv:1: \"???\" does not have 4 fields; expected index,x,y,z");
  CHECK(error_of(std::string(1000, 'x')) ==
        "t.csv:1: \"" + std::string(40, 'x') + "...\" does not have 4 fields; expected index,x,y,z");
}

TEST_CASE("a complete table has every vertex") {
  const SceneFile file("1,1,0,0\n0,0,0,0\n2,2,0,0\n", "t.csv");
  CHECK(read_complete_vertex_csv(file.path(), 3) == std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  CHECK(file.error_of([&] { read_complete_vertex_csv(file.path(), 5); }) ==
        "t.csv: misses 2 of 5 vertices, the first is 3; expected a line for every vertex");
  write_file(file.path(), "0,0,0,0\n2,2,0,0\n");
  CHECK(file.error_of([&] { read_complete_vertex_csv(file.path(), 3); }) ==
        "t.csv: misses 1 of 3 vertices, the first is 1; expected a line for every vertex");
  CHECK(file.error_of([&] { read_vertex_csv(file / "none.csv", 3); }) ==
        "none.csv: no such file; expected a readable file");
}
