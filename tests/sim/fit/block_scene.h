// A small block as a scene on disk, for fits: two regions, held at one end, stretched at the other.
#pragma once
#include <fstream>
#include <random>
#include <string>

#include "sim/fit/fit.h"
#include "sim/fit/simulated/reference_simulator.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "tests/support/support.h"

namespace fascia::test {

inline const ReferenceSimulator kReference;
inline constexpr double kBlockLength = 0.12;  // [m] along x; 0.04 across

/// `extra`: keys of the scene, each with a comma at its end.
struct BlockScene {
  TemporaryFolder folder;
  std::filesystem::path file;

  explicit BlockScene(const std::string& material = R"("young_modulus": 20000, "poisson_ratio": 0.4)",
                      const std::string& extra = "", const std::string& prescribed = stretched()) {
    TetMesh mesh = make_box(6, 2, 2, {kBlockLength, 0.04, 0.04});
    mesh.regions.clear();
    for (const Tet& tet : mesh.tets) {
      double middle = 0;
      for (const std::uint32_t v : tet) middle += mesh.positions[v].x() / 4;
      mesh.regions.push_back(middle < kBlockLength / 2 ? 1 : 2);
    }
    mesh.region_names = {{1, "soft"}, {2, "stiff"}};
    write_mesh(folder / "block.msh", mesh);
    file = folder / "block.json";
    std::ofstream(file) << R"({"fascia_scene": 1, )" << extra << R"("bodies": [{"name": "block", "mesh": "block.msh",
      "materials": {"default": {"model": "stable_neo_hookean", )"
                        << material << R"(}, "stiff": {"young_modulus": 60000}},
      "fixed": [{"box": [[-1, -1, -1], [0.0001, 1, 1]]}], "prescribed": [)"
                        << prescribed << "]}]}";
  }
  /// Ends at 0.02 m after a second.
  static std::string stretched() {
    return R"({"select": {"box": [[0.1199, -1, -1], [1, 1, 1]]}, "translate": [0.02, 0, 0], "start": 0, "duration": 1})";
  }

  Scene scene(const std::vector<std::string>& sets = {}) const { return open_scene(file, sets); }
};

/// A curve of one component at these times, without values.
inline MeasuredCurve curve_of(const std::string& name, Measurand measurand, std::vector<double> times) {
  const Dimension dimension = measurand.kind == Measurand::Kind::vertex ? Dimension::length : Dimension::force;
  const std::size_t count = times.empty() ? 1 : times.size();
  return {name, measurand, dimension, std::move(times), std::vector<double>(count, 0), 1};
}

/// Adds noise of `share` of the largest value of each curve.
inline void add_noise(std::vector<Measurement>& measurements, double share, unsigned seed) {
  std::mt19937 random(seed);
  for (Measurement& measurement : measurements)
    for (MeasuredCurve& curve : measurement.curves) {
      double largest = 0;
      for (const double value : curve.values) largest = std::max(largest, std::abs(value));
      std::normal_distribution<double> normal(0, 1);
      for (double& value : curve.values) value += share * largest * normal(random);
    }
}

/// Sets the values of the curves to those that the scene simulates, and adds noise.
inline void measure(std::vector<Measurement>& measurements, const Scene& scene, bool is_static, double share,
                    unsigned seed) {
  const Experiment experiment(measurements, is_static, scene.duration, kReference);
  const auto response = experiment.run(scene, build_model(scene));
  if (!response) throw std::runtime_error("the scene to be measured does not converge");
  Eigen::Index row = 0;
  for (Measurement& measurement : measurements)
    for (MeasuredCurve& curve : measurement.curves)
      for (double& value : curve.values) value = response->values[row++];
  add_noise(measurements, share, seed);
}

inline std::vector<double> moments(int count, double end) {
  std::vector<double> times;
  for (int i = 1; i <= count; ++i) times.push_back(end * i / count);
  return times;
}

}  // namespace fascia::test
