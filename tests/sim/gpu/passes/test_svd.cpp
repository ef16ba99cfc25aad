// The kernels' singular value decomposition in float32 against Eigen's in double precision.
#include <catch2/catch.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <functional>
#include <random>

#include "base/file.h"
#include "gl/compute_pass.h"
#include "shaders/shared/types.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using shared::vec4;

namespace {

constexpr std::uint32_t kBatch = 1u << 18;

const char* const kKernel = R"(#include "common/io.glsl"
#include "common/svd.glsl"
COMPUTE_1D
INPUT_VEC4(Matrix, matrix)
OUTPUT(vec4, Factors, factors)

void main() {
  ITEM_OR_RETURN(i)
  Svd svd = signed_svd(mat3(FETCH(matrix, 3u * i).xyz, FETCH(matrix, 3u * i + 1u).xyz, FETCH(matrix, 3u * i + 2u).xyz), true);
  for (int k = 0; k < 3; ++k) {
    factors[6u * i + uint(k)] = vec4(svd.u[k], svd.s[k]);
    factors[6u * i + 3u + uint(k)] = vec4(svd.v[k], 0.0);
  }
}
)";

struct Random {
  std::mt19937 engine{5};
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  Matrix3d any() {
    Matrix3d m;
    for (int k = 0; k < 9; ++k) m.data()[k] = uniform(-1, 1);
    return m;
  }
  Matrix3d rotation() {
    const Eigen::Quaterniond q(Eigen::Vector4d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
    return q.normalized().toRotationMatrix();
  }
  Matrix3d stretched(const Vector3d& s) { return rotation() * s.asDiagonal() * rotation(); }
};

// The matrices of one kind: deformation gradients of failed and of regular states.
const std::vector<std::pair<const char*, std::function<Matrix3d(Random&)>>> kKinds = {
    {"any entries", [](Random& r) { return r.any(); }},
    {"any size", [](Random& r) -> Matrix3d { return std::pow(10.0, r.uniform(-12, 12)) * r.any(); }},
    {"nearly a rotation",
     [](Random& r) -> Matrix3d { return r.rotation() + std::pow(10.0, r.uniform(-8, -1)) * r.any(); }},
    {"three equal", [](Random& r) { return r.stretched(Vector3d::Constant(r.uniform(-2, 2))); }},
    {"two equal",
     [](Random& r) {
       const double a = r.uniform(-2, 2);
       return r.stretched({a, a, r.uniform(-2, 2)});
     }},
    {"nearly equal",
     [](Random& r) {
       const double a = r.uniform(0.5, 2);
       return r.stretched({a, a * (1 + 1e-6), -a * (1 - 1e-6)});
     }},
    {"flat",
     [](Random& r) {
       return r.stretched({r.uniform(0, 2), r.uniform(0, 2), 0});
     }},
    {"a line",
     [](Random& r) {
       return r.stretched({r.uniform(0, 2), 0, 0});
     }},
    {"a point", [](Random&) -> Matrix3d { return Matrix3d::Zero(); }},
    {"inside out",
     [](Random& r) {
       return r.stretched({r.uniform(0, 3), r.uniform(0, 3), -r.uniform(0, 3)});
     }},
    {"needles and slivers",
     [](Random& r) {
       return r.stretched(
           {std::pow(10.0, r.uniform(-3, 3)), std::pow(10.0, r.uniform(-3, 3)), -std::pow(10.0, r.uniform(-3, 3))});
     }},
    {"whole numbers", [](Random& r) -> Matrix3d { return (2.4 * r.any()).array().round().matrix(); }},
};

vec4 to_vec4(const Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0};
}
Vector3d vector(const vec4& v) { return {v.x, v.y, v.z}; }

}  // namespace

TEST_CASE("signed singular values on the GPU, of three million matrices", "[gpu]") {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "common");
  for (const char* file : {"common/io.glsl", "common/svd.glsl"})
    std::filesystem::copy_file(source_dir() / "shaders" / file, folder / file);
  write_file(folder / "svd.comp", kKernel);
  Gpu gpu;
  gl::ProgramCache programs(folder.path(), gl::LoadPath::texel);
  gl::Buffer input("matrix", 3 * sizeof(vec4) * kBatch), output("factors", 6 * sizeof(vec4) * kBatch);
  const gl::ComputePass pass(programs.compute("svd.comp"), {{"matrix", &input}, {"factors", &output}}, kBatch);

  Random random;
  for (const auto& [kind, make] : kKinds) {
    std::vector<vec4> columns;
    std::vector<Matrix3d> matrices;
    for (std::uint32_t i = 0; i < kBatch; ++i) {
      const Matrix3d m = make(random).cast<float>().cast<double>();  // the input of the GPU
      matrices.push_back(m);
      for (int k = 0; k < 3; ++k) columns.push_back(to_vec4(m.col(k)));
    }
    input.upload(0, input.bytes(), columns.data());
    pass.run();
    const std::vector<vec4> factors = output.read<vec4>();
    double worst_product = 0, worst_rotation = 0,
           worst_value = 0;  // relative to the largest singular value; for the rotations absolute
    std::uint32_t wrong_order = 0, wrong_sign = 0;
    for (std::uint32_t i = 0; i < kBatch; ++i) {
      Matrix3d u, v;
      Vector3d s;
      for (int k = 0; k < 3; ++k) {
        const vec4& column = factors[6 * i + static_cast<std::uint32_t>(k)];
        u.col(k) = vector(column);
        s[k] = column.w;
        v.col(k) = vector(factors[6 * i + 3 + static_cast<std::uint32_t>(k)]);
      }
      const Matrix3d& f = matrices[i];
      const Vector3d exact = Eigen::JacobiSVD<Matrix3d>(f).singularValues();
      const double size = std::max(exact[0], 1e-300);
      // std::max drops NaNs, addition keeps them: a NaN must not pass.
      const double product = (u * s.asDiagonal() * v.transpose() - f).norm() / size;
      const double rotation = (u * u.transpose() - Matrix3d::Identity()).norm() +
                              (v * v.transpose() - Matrix3d::Identity()).norm() + std::abs(u.determinant() - 1) +
                              std::abs(v.determinant() - 1);
      const double value = (s.cwiseAbs() - exact).norm() / size;
      worst_product = product <= worst_product ? worst_product : product;
      worst_rotation = rotation <= worst_rotation ? worst_rotation : rotation;
      worst_value = value <= worst_value ? worst_value : value;
      const double slack = 2e-6 * size;
      wrong_order += !(s[0] >= s[1] - slack && s[1] >= std::abs(s[2]) - slack);
      // The sign of a volume that is only rounding is arbitrary.
      wrong_sign += std::abs(f.determinant()) > 1e-5 * size * size * size && (f.determinant() > 0) != (s[2] > 0);
    }
    CAPTURE(kind, worst_product, worst_rotation, worst_value, wrong_order, wrong_sign);
    CHECK(worst_product < 3e-6);
    CHECK(worst_rotation < 6e-6);
    CHECK(worst_value < 2e-6);
    CHECK(wrong_order == 0);
    CHECK(wrong_sign == 0);
  }
}
