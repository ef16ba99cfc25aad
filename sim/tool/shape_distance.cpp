#include "sim/tool/shape_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/tool/solid_mesh.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// To everything within `radius` of the nearest point of a core that lies at `away` from the point. `flat`: directions
// along which the core goes on, as columns' projector.
ShapeDistance from_core(const Vector3d& away, double radius, const Matrix3d& flat) {
  const double length = away.norm();
  ShapeDistance result;
  result.distance = length - radius;
  result.normal = length > 0 ? Vector3d(away / length) : Vector3d(0, 1, 0);
  result.curvature = Matrix3d::Zero();
  if (length > 0) result.curvature = (Matrix3d::Identity() - flat - result.normal * result.normal.transpose()) / length;
  return result;
}

struct Distance {
  Vector3d x;

  ShapeDistance operator()(const SphereShape& s) const { return from_core(x - s.center, s.radius, Matrix3d::Zero()); }

  ShapeDistance operator()(const CapsuleShape& s) const {
    const Vector3d along = s.to - s.from;
    const double share = (x - s.from).dot(along) / along.squaredNorm();
    if (share <= 0) return from_core(x - s.from, s.radius, Matrix3d::Zero());
    if (share >= 1) return from_core(x - s.to, s.radius, Matrix3d::Zero());
    const Vector3d axis = along.normalized();
    return from_core(x - s.from - share * along, s.radius, axis * axis.transpose());
  }

  ShapeDistance operator()(const PlaneShape& s) const {
    const Vector3d n = s.normal.normalized();
    return {n.dot(x - s.point), n, Matrix3d::Zero()};
  }

  ShapeDistance operator()(const BoxShape& s) const {
    const Vector3d local = x - s.center, core = s.half_size.array() - s.round, beyond = local.cwiseAbs() - core;
    const Vector3d side = local.unaryExpr([](double c) { return c < 0 ? -1.0 : 1.0; });
    if (beyond.maxCoeff() > 0) {
      Matrix3d flat = Matrix3d::Zero();
      for (int k = 0; k < 3; ++k) flat(k, k) = beyond[k] > 0 ? 0 : 1;
      return from_core(side.cwiseProduct(beyond.cwiseMax(0)), s.round, flat);
    }
    Eigen::Index face = 0;
    const double depth = beyond.maxCoeff(&face);
    return {depth - s.round, side[face] * Vector3d::Unit(face), Matrix3d::Zero()};
  }

  ShapeDistance operator()(const CylinderShape& s) const {
    const Vector3d axis = (s.to - s.from).normalized(), local = x - 0.5 * (s.from + s.to);
    const double height = local.dot(axis), side = height < 0 ? -1 : 1;
    const Vector3d across = local - height * axis;
    const double radial = across.norm();
    const Vector3d outward = radial > 0 ? Vector3d(across / radial) : Vector3d(axis.unitOrthogonal());
    const double past_rim = radial - (s.radius - s.round),
                 past_end = std::abs(height) - (0.5 * (s.to - s.from).norm() - s.round);
    const Vector3d around = axis.cross(outward);
    const Matrix3d hoop = radial > 0 ? Matrix3d(around * around.transpose() / radial) : Matrix3d(Matrix3d::Zero());
    if (past_rim > 0 && past_end > 0) {
      ShapeDistance edge = from_core(past_rim * outward + past_end * side * axis, s.round, around * around.transpose());
      edge.curvature += edge.normal.dot(outward) * hoop;
      return edge;
    }
    if (past_rim > past_end) return {past_rim - s.round, outward, hoop};
    return {past_end - s.round, side * axis, Matrix3d::Zero()};
  }

  ShapeDistance operator()(const MeshShape& s) const { return distance_to(*s.solid, x); }
};

}  // namespace

ShapeDistance distance_to(const ToolShape& shape, const Vector3d& point) { return std::visit(Distance{point}, shape); }

double gap_to(const ToolShape& shape, const Vector3d& point) {
  const auto* mesh = std::get_if<MeshShape>(&shape);
  return mesh ? gap_to(*mesh->solid, point) : distance_to(shape, point).distance;
}

double finest_radius(const ToolShape& shape) {
  struct Finest {
    double operator()(const SphereShape& s) const { return s.radius; }
    double operator()(const CapsuleShape& s) const { return s.radius; }
    double operator()(const CylinderShape& s) const { return std::min(s.radius, 0.5 * (s.to - s.from).norm()); }
    double operator()(const BoxShape& s) const { return s.half_size.minCoeff(); }
    double operator()(const PlaneShape&) const { return std::numeric_limits<double>::infinity(); }
    // Between those of a ball (a half of the result), a rod (three quarters) and a plate (one and a half).
    double operator()(const MeshShape& s) const { return 0.75 * s.solid->thickness; }
  };
  return std::visit(Finest{}, shape);
}

double sharpest_edge(const ToolShape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->round;
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) return cylinder->round;
  return std::numeric_limits<double>::infinity();
}

bool near_edge(const ToolShape& shape, const Vector3d& point, double width) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    const Vector3d beyond = (point - box->center).cwiseAbs() - box->half_size;
    return (beyond.array() > -width).count() >= 2;
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
    const Vector3d half = 0.5 * (cylinder->to - cylinder->from), local = point - cylinder->from - half;
    const double height = local.dot(half.normalized());
    const double across = (local - height * half.normalized()).norm();
    return across - cylinder->radius > -width && std::abs(height) - half.norm() > -width;
  }
  return false;
}

Vector3d middle_of(const ToolShape& shape) {
  struct Middle {
    Vector3d operator()(const SphereShape& s) const { return s.center; }
    Vector3d operator()(const CapsuleShape& s) const { return 0.5 * (s.from + s.to); }
    Vector3d operator()(const CylinderShape& s) const { return 0.5 * (s.from + s.to); }
    Vector3d operator()(const BoxShape& s) const { return s.center; }
    Vector3d operator()(const PlaneShape& s) const { return s.point; }
    Vector3d operator()(const MeshShape& s) const { return s.solid->box.center(); }
  };
  return std::visit(Middle{}, shape);
}

double bounding_radius(const ToolShape& shape) {
  struct Bound {
    double operator()(const SphereShape& s) const { return s.radius; }
    double operator()(const CapsuleShape& s) const { return 0.5 * (s.to - s.from).norm() + s.radius; }
    double operator()(const CylinderShape& s) const { return std::hypot(0.5 * (s.to - s.from).norm(), s.radius); }
    double operator()(const BoxShape& s) const { return s.half_size.norm(); }
    double operator()(const PlaneShape&) const { return std::numeric_limits<double>::infinity(); }
    double operator()(const MeshShape& s) const { return 0.5 * s.solid->box.sizes().norm(); }
  };
  return std::visit(Bound{}, shape);
}

}  // namespace fascia
