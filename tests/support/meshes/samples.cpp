#include "tests/support/meshes/samples.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "base/error.h"

namespace fascia::test {

TetMesh sample_mesh() {
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1.5}, {9, 8, 7}};
  mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  mesh.regions = {3, 7};
  mesh.region_names = {{3, "left part"}, {7, "right"}};
  mesh.groups = {
      {"left part", {0, 1, 2, 3}}, {"right", {1, 2, 3, 4}}, {"clamp", {0, 1, 2}}, {"5", {0, 1}}, {"tip", {4}}};
  return mesh;
}

std::vector<MeshSample> all_samples() {
  std::vector<MeshSample> all = gmsh_samples();
  for (const auto& more : {vtk_samples(), vtu_samples(), other_samples()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::string sample_content(const std::string& file) {
  for (const MeshSample& one : all_samples())
    if (one.file == file) return one.content;
  FAIL("no sample " << file);
  return "";
}

namespace {

void write_raw(const std::filesystem::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

}  // namespace

std::filesystem::path write_sample(const TemporaryFolder& folder, const MeshSample& sample) {
  const std::filesystem::path path = folder / sample.file;
  write_raw(path, sample.content);
  if (!sample.node_content.empty())
    write_raw(std::filesystem::path(path).replace_extension(".node"), sample.node_content);
  return path;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  INFO("looking for " << from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& file, const std::string& content, const std::string& node_content) {
  const TemporaryFolder folder;
  const std::filesystem::path path = write_sample(folder, {"", file, content, Keeps::tets, node_content});
  try {
    read_mesh(path);
  } catch (const Error& error) {
    const std::string text = error.what(), prefix = folder.path().string() + "/";
    CHECK(text.find('\n') == std::string::npos);
    CHECK(text.starts_with(prefix));
    return text.substr(prefix.size());
  }
  return "";
}

void check_sample(const MeshFile& file, const MeshSample& sample) {
  const TetMesh expected = sample_mesh();
  CHECK(file.format == sample.format);
  CHECK(file.mesh.positions == expected.positions);
  CHECK(file.mesh.tets == expected.tets);
  if (sample.keeps == Keeps::tets) {
    CHECK(file.mesh.regions == std::vector<int>{0, 0});
    CHECK(file.mesh.groups.empty());
    return;
  }
  CHECK(file.mesh.regions == expected.regions);
  if (sample.keeps == Keeps::groups) {
    CHECK(file.mesh.region_names == expected.region_names);
    CHECK(file.mesh.groups == expected.groups);
    return;
  }
  std::map<std::string, std::vector<std::uint32_t>> groups = {{"3", {0, 1, 2, 3}}, {"7", {1, 2, 3, 4}}};
  if (sample.keeps == Keeps::numbers) groups.insert({{"11", {0, 1, 2}}, {"5", {0, 1}}, {"9", {4}}});
  CHECK(file.mesh.region_names.empty());
  CHECK(file.mesh.groups == groups);
}

}  // namespace fascia::test
