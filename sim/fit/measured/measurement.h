// What was measured: curves of forces and displacements over time, or single values of them, and deformed shapes.
//
// Curves are CSV files with the column names that `fascia run --history` writes, each with its unit: time_s,
// reaction_y_N, support_1_x_mN, probe_x_mm. Shapes are CSV files index,x,y,z of vertices, as --export writes them, or
// surfaces and meshes, whose points have no vertex and are compared by their distance to the simulated surface.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/fit/measured/unit.h"
#include "sim/model/model.h"

namespace fascia {

/// A component of a vector that a simulation has at every time.
struct Measurand {
  enum class Kind { reaction, grab, support, contact, vertex } kind;  // forces [N]; vertex: its displacement [m]
  std::size_t index;  // support in the order of reference::support_forces, tool of the model, vertex; else 0
  int axis;           // 0 to 2
};

struct MeasuredCurve {
  std::string name;  // "reaction_y"
  Measurand measurand;
  Dimension dimension;
  std::vector<double> times;   // [s] ascending or not; empty: one value, at the end
  std::vector<double> values;  // [times] [N] or [m]
  double noise = 0;            // standard deviation [N] or [m]
};

struct MeasuredShape {
  std::vector<std::uint32_t> vertices;     // [positions]; empty: points of a surface
  std::vector<Eigen::Vector3d> positions;  // [m]
  double noise = 0;                        // standard deviation [m]
  std::size_t value_count() const { return vertices.empty() ? positions.size() : 3 * positions.size(); }
};

struct Measurement {
  std::filesystem::path file;
  double weight = 1;  // of the squares of its residuals
  std::vector<MeasuredCurve> curves;
  std::vector<MeasuredShape> shapes;
  std::vector<std::string> notes;  // what is left out, one line each
};

struct MeasurementRead {
  std::uint32_t probe;                   // vertex of the columns probe_*, unless the file names one
  std::vector<std::string> passed_over;  // names of columns of a history that no measurement has
  std::vector<std::string> columns;      // only these, as "reaction_y" or "reaction"; empty: all
};

/// Throws Error "file:line: ..." for an unknown column or unit, a cell that is no number, and for no values.
Measurement read_measurement(const std::filesystem::path& file, const Model& model, const MeasurementRead& how);

/// The standard deviation of measured values.
struct Noise {
  double value = 0.01;
  bool relative = true;  // to the largest length of the vector, in a shape of the displacement; else [N] or [m]
  Dimension dimension = Dimension::force;
};
/// Sets the noise of every curve and shape: the last entry that fits it, else a hundredth of its largest value.
void assign_noise(std::vector<Measurement>& measurements, const std::vector<Noise>& noise, const Model& model);

}  // namespace fascia
