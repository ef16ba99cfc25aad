#include "sim/accuracy/spread_loads.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "sim/accuracy/recovered_stress.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

/// Accelerations of the inner vertices, and from there on, ring by ring, the means of what is known around.
Vectors field_of(const Vectors& forces, const std::vector<double>& masses, const std::vector<char>& held,
                 const std::vector<char>& surface, const Middles& middles) {
  Vectors field(masses.size(), Vector3d::Zero());
  std::vector<char> known(masses.size());
  const auto take = [&](bool of_surface) {
    for (std::size_t v = 0; v < known.size(); ++v) {
      if (masses[v] == 0 || held[v] || known[v] || (surface[v] && !of_surface)) continue;
      field[v] = forces[v] / masses[v];
      known[v] = 1;
    }
  };
  take(false);
  for (bool thin = false;; thin = true) {
    for (bool grows = true; grows;) {
      Vectors sum(known.size(), Vector3d::Zero());
      std::vector<int> count(known.size());
      for (const auto& [ends, middle] : middles)
        for (const auto& [from, to] : {std::pair(ends[0], ends[1]), std::pair(ends[1], ends[0])})
          if (known[from] && !known[to]) {
            sum[to] += field[from];
            ++count[to];
          }
      grows = false;
      for (std::size_t v = 0; v < known.size(); ++v)
        if (count[v] > 0) {
          field[v] = sum[v] / count[v];
          known[v] = grows = true;
        }
    }
    if (thin) return field;
    take(true);  // parts without inner vertices
  }
}

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// int N_i N_j dA over the area of a face: of the quadratic functions, or of the linear ones of its corners.
const Matrix6d& masses_of_face(bool linear) {
  static const auto masses = [] {
    std::array<Matrix6d, 2> of;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        const bool opposite = (i < 3) != (j < 3) && (std::min(i, j) + 1) % 3 == std::max(i, j) - 3;
        of[0](i, j) = (i < 3 && j < 3     ? (i == j ? 6 : -1)
                       : i >= 3 && j >= 3 ? (i == j ? 32 : 16)
                       : opposite         ? -4
                                          : 0) /
                      180.0;
        of[1](i, j) = i < 3 && j < 3 ? (i == j ? 2 : 1) / 12.0 : 0;
      }
    return of;
  }();
  return masses[linear ? 1 : 0];
}

std::array<std::uint32_t, 2> ends_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

FaceLoad unloaded(const Model& model, const Triangle& face, const Middles& middles) {
  FaceLoad load{{face[0], face[1], face[2]}, {}, 0};
  for (std::size_t k = 0; k < 3; ++k) load.vertices[3 + k] = middles.at(ends_of(face[k], face[(k + 1) % 3]));
  load.traction.fill(Vector3d::Zero());
  const Vector3d& x = model.rest_positions[face[0]];
  load.area = 0.5 * (model.rest_positions[face[1]] - x).cross(model.rest_positions[face[2]] - x).norm();
  return load;
}

std::vector<Tet> corners_of(const Model& model, const std::vector<std::uint32_t>& tets) {
  std::vector<Tet> corners;
  for (const std::uint32_t t : tets) corners.push_back(model.tets[t]);
  return corners;
}

constexpr double kFloor = 0.01;  // of a face that is loaded at single vertices

/// The forces on functions L_a, from those on quadratic functions.
Vectors on_corners(const std::vector<FaceLoad>& faces, const Vectors& forces) {
  Vectors result = forces;
  std::vector<char> met(forces.size());
  for (const FaceLoad& face : faces)
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::exchange(met[face.vertices[3 + k]], 1)) continue;
      for (const std::uint32_t v : {face.vertices[k], face.vertices[(k + 1) % 3]})
        result[v] += 0.5 * forces[face.vertices[3 + k]];
    }
  return result;
}

/// How much a face bears: 0 where a corner has no load, 1 where all have the same; and the directions of the loads, of
/// trace 1.
struct Activity {
  double share = 1;
  Matrix3d directions = Matrix3d::Zero();
};

/// The loads of corners are their forces over the areas of the faces that bear them, and the other way round.
std::vector<Activity> activities_of(const std::vector<FaceLoad>& faces, const std::vector<char>& held,
                                    const Vectors& forces) {
  constexpr int kRounds = 4;
  std::vector<Activity> activities(faces.size());
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> areas(held.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        areas[faces[f].vertices[k]] += faces[f].area / 3 * (activities[f].share + kFloor);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      double least = std::numeric_limits<double>::infinity(), most = 0;  // of the corners whose forces are known
      Matrix3d directions = Matrix3d::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = faces[f].vertices[k];
        if (held[v]) continue;
        const Vector3d load = forces[v] / areas[v];
        directions += load * load.transpose();
        least = std::min(least, load.norm());
        most = std::max(most, load.norm());
      }
      activities[f] = {most > 0 ? least / most : 0, directions};
      if (most > 0) activities[f].directions /= directions.trace();
    }
  }
  return activities;
}

/// [face][of its vertices] the part of a vertex's force that a face bears.
std::vector<std::array<Vector3d, 6>> parts_of(const std::vector<FaceLoad>& faces, const std::vector<char>& held,
                                              const Vectors& forces, bool linear) {
  const std::vector<Activity> activities = activities_of(faces, held, linear ? forces : on_corners(faces, forces));
  const std::size_t functions = linear ? 3 : 6;
  std::vector<Matrix3d> weights(faces.size()), sums(held.size(), Matrix3d::Zero());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    weights[f] = faces[f].area * (activities[f].share * activities[f].directions + kFloor * Matrix3d::Identity());
    for (std::size_t i = 0; i < functions; ++i) sums[faces[f].vertices[i]] += weights[f];
  }
  std::vector<std::array<Vector3d, 6>> parts(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < functions; ++i) {
      const std::uint32_t v = faces[f].vertices[i];
      parts[f][i] = held[v] ? Vector3d(0, 0, 0) : Vector3d(weights[f] * sums[v].ldlt().solve(forces[v]));
    }
  return parts;
}

}  // namespace

Middles middles_of(const std::vector<MidEdge>& edges) {
  Middles middles;
  for (const MidEdge& edge : edges) middles.emplace(ends_of(edge.a, edge.b), edge.vertex);
  return middles;
}

Vectors spread_field(const Model& model, const std::vector<std::uint32_t>& tets, const Middles& middles,
                     const Vectors& forces) {
  const std::vector<char> held = model.held();
  std::vector<double> masses(held.size());
  std::vector<char> of_surface(held.size());
  for (const std::uint32_t t : tets)
    for (const std::uint32_t v : model.tets[t])
      masses[v] += model.materials[model.tet_material[t]].density * volume_of(model, t) / 4;
  for (const Triangle& face : boundary_triangles(corners_of(model, tets)))
    for (const std::uint32_t v : face) of_surface[v] = 1;
  return field_of(forces, masses, held, of_surface, middles);
}

std::vector<FaceLoad> spread_on_faces(const Model& model, const std::vector<std::uint32_t>& tets,
                                      const Middles& middles, const std::vector<char>& held, const Vectors& forces,
                                      bool linear) {
  std::vector<FaceLoad> faces;
  for (const Triangle& face : boundary_triangles(corners_of(model, tets)))
    faces.push_back(unloaded(model, face, middles));
  const auto parts = parts_of(faces, held, forces, linear);
  const Matrix6d& masses = masses_of_face(linear);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    FaceLoad& face = faces[f];
    std::vector<int> free;
    for (int i = 0; i < (linear ? 3 : 6); ++i)
      if (!held[face.vertices[static_cast<std::size_t>(i)]]) free.push_back(i);
    const auto count = static_cast<Eigen::Index>(free.size());
    if (count == 0) continue;
    Eigen::MatrixXd of_free(count, count), right(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto vertex = static_cast<std::size_t>(free[static_cast<std::size_t>(i)]);
      right.row(i) = parts[f][vertex].transpose();
      for (Eigen::Index j = 0; j < count; ++j)
        of_free(i, j) = face.area * masses(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
    }
    const Eigen::MatrixXd values = of_free.ldlt().solve(right);
    for (Eigen::Index i = 0; i < count; ++i)
      face.traction[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])] = values.row(i).transpose();
    for (std::size_t k = 0; linear && k < 3; ++k)
      face.traction[3 + k] = 0.5 * (face.traction[k] + face.traction[(k + 1) % 3]);
  }
  return faces;
}

std::vector<FaceLoad> on_finer_faces(const std::vector<FaceLoad>& loads, const Model& finer,
                                     const Middles& finer_middles) {
  // Two middles of edges have one face in common.
  std::map<std::array<std::uint32_t, 2>, std::size_t> owners;
  for (std::size_t f = 0; f < loads.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      owners.emplace(ends_of(loads[f].vertices[3 + k], loads[f].vertices[3 + (k + 1) % 3]), f);
  std::vector<FaceLoad> result;
  for (const Triangle& face : boundary_triangles(finer.tets)) {
    FaceLoad& fine = result.emplace_back(unloaded(finer, face, finer_middles));
    auto owner = owners.end();
    for (std::size_t k = 0; k < 3 && owner == owners.end(); ++k)
      owner = owners.find(ends_of(face[k], face[(k + 1) % 3]));
    const FaceLoad& whole = loads[owner->second];
    std::array<Vector3d, 6> places;  // barycentric, in the whole face
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = static_cast<std::size_t>(std::find(whole.vertices.begin(), whole.vertices.end(), face[k]) -
                                              whole.vertices.begin());
      const auto a = static_cast<int>(n % 3), b = static_cast<int>((n + (n < 3 ? 0 : 1)) % 3);
      places[k] = 0.5 * (Vector3d::Unit(a) + Vector3d::Unit(b));
    }
    for (std::size_t k = 0; k < 3; ++k) places[3 + k] = 0.5 * (places[k] + places[(k + 1) % 3]);
    for (std::size_t i = 0; i < 6; ++i)
      for (int k = 0; k < 3; ++k) {
        const double own = places[i][k], next = places[i][(k + 1) % 3];
        fine.traction[i] += own * (2 * own - 1) * whole.traction[static_cast<std::size_t>(k)] +
                            4 * own * next * whole.traction[static_cast<std::size_t>(3 + k)];
      }
  }
  return result;
}

std::array<Vector3d, 6> forces_of(const FaceLoad& load) {
  const Matrix6d& masses = masses_of_face(false);
  std::array<Vector3d, 6> forces;
  for (int i = 0; i < 6; ++i) {
    Vector3d& force = forces[static_cast<std::size_t>(i)];
    force.setZero();
    for (int j = 0; j < 6; ++j) force += load.area * masses(i, j) * load.traction[static_cast<std::size_t>(j)];
  }
  return forces;
}

}  // namespace fascia
