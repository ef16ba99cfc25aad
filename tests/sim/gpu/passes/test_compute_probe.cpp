// Devices that accept every call without computing, or return garbage, are reported as such.
#include <catch2/catch.hpp>

#include <cmath>

#include "base/error.h"
#include "sim/gpu/passes/compute_probe.h"
#include "sim/gpu/solver.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;

namespace {

// Replaces one of OpenGL's functions until the end of the scope.
template <class F>
class Replaced {
 public:
  Replaced(F& function, F other) : function_(function), before_(function) { function = other; }
  ~Replaced() { function_ = before_; }

 private:
  F& function_;
  F before_;
};

Model hanging_box() {
  return make_model(make_box(3, 2, 2, {0.3, 0.2, 0.2}), {1e5, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff},
                    [](const Eigen::Vector3d& x) { return x.x() < 1e-9; });
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace

TEST_CASE("a driver that discards dispatches is reported before the first step", "[gpu]") {
  Gpu gpu(GENERATE(gl::LoadPath::texel, gl::LoadPath::storage));
  const Model model = hanging_box();
  const Replaced replaced(gl::DispatchCompute, decltype(gl::DispatchCompute)([](GLuint, GLuint, GLuint) {}));
  const std::string message = message_of([&] { GpuSolver(gpu.programs, model, {}); });
  CAPTURE(message);
  CHECK(message.find(gl::device().renderer) == 0);
  CHECK(message.find("a kernel that ran left nothing") != std::string::npos);
}

TEST_CASE("a driver that returns garbage is reported before the first step, and none of its numbers becomes an index",
          "[gpu]") {
  static GLubyte garbage;
  garbage = GENERATE(as<GLubyte>{}, 0x00, 0x5a, 0xff);
  Gpu gpu;
  const Model model = hanging_box();
  SolverSettings settings;
  settings.method = GENERATE(Method::two_level, Method::vertex_descent);
  settings.acceleration = Acceleration::none;
  const auto fill = [](GLenum, GLintptr, GLsizeiptr bytes, void* data) {
    std::fill_n(static_cast<GLubyte*>(data), bytes, garbage);
  };
  SECTION("from the start") {
    const Replaced replaced(gl::GetBufferSubData, decltype(gl::GetBufferSubData)(fill));
    const std::string message = message_of([&] { GpuSolver(gpu.programs, model, settings); });
    CAPTURE(message);
    CHECK(message.find(gl::device().renderer) == 0);
  }
  SECTION("later") {
    GpuSolver solver(gpu.programs, model, settings);
    solver.step();
    solver.request_check();
    const Replaced replaced(gl::GetBufferSubData, decltype(gl::GetBufferSubData)(fill));
    std::optional<StateGuard::Verdict> verdict;
    const std::string message = message_of([&] { verdict = solver.take_check(true); });
    CAPTURE(static_cast<int>(garbage), message);
    if (verdict)
      CHECK((!verdict->diverged || *verdict->diverged < model.rest_positions.size()));
    else
      CHECK(message.find("expected one below " + std::to_string(model.rest_positions.size())) != std::string::npos);
  }
}

TEST_CASE("results that no working device returns for a start", "[gpu]") {
  Gpu gpu;
  const Model model = hanging_box();
  State state = initial_state(model);
  CHECK(message_of([&] { require_computed(model, state); }).find("no vertex has moved") != std::string::npos);
  const std::vector<char> held = model.held();
  const auto free = static_cast<std::size_t>(std::find(held.begin(), held.end(), 0) - held.begin());
  state.displacement[free].x() = 1e-30;
  CHECK_NOTHROW(require_computed(model, state));
  for (Eigen::Vector3d& u : state.displacement) u.setConstant(std::nan(""));
  CHECK(message_of([&] { require_computed(model, state); }).find("no vertex is finite") != std::string::npos);
  state.displacement[free].setConstant(1e-30);
  CHECK_NOTHROW(require_computed(model, state));
}

TEST_CASE("the trial box moves with every method", "[gpu]") {
  Gpu gpu;
  const Model box = trial_model();
  for (const SolverChoice& pair : solver_choices()) {
    CAPTURE(name_of(pair.method), name_of(pair.acceleration));
    SolverSettings settings;
    settings.method = pair.method;
    settings.acceleration = pair.acceleration;
    GpuSolver solver(gpu.programs, box, settings);
    solver.step();
    CHECK_NOTHROW(require_computed(box, solver.download()));
  }
}
