// Solver methods and their accelerations: one table of each, with names, help and valid combinations. A method's
// kernels are in sim/gpu/methods.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/material/material.h"

namespace fascia {

enum class Method { jacobi, mass_splitting, gauss_seidel, exact_xpbd, vertex_descent, two_level };
enum class Acceleration { none, chebyshev, anderson_positions, anderson, nonlinear_cg, subspace };

struct MethodInfo {
  Method method;
  const char *name, *label, *help;              // in scene files; in menus; description with cost and limits
  std::vector<Acceleration> accelerations;      // that suit the method, best first
  std::vector<std::string_view> settings = {};  // solver settings that have no effect with other methods
  bool carries_every_law = false;  // else only laws quadratic in the Green strain, which is the constraint of XPBD
  bool carries_quadratic = false;  // quadratic elements, too
  bool carries_contact = false;    // scenes with ground, obstacles or instruments, too
  bool in_i3d2019 = false;     // the methods of the I3D 2019 paper (Boukadida, Andrews, Paquette), and mass splitting
  std::size_t dispatches = 1;  // approximate number of expensive dispatches per iteration
};

struct AccelerationInfo {
  Acceleration acceleration;
  const char *name, *label, *help;         // as in MethodInfo
  std::vector<std::string_view> settings;  // as in MethodInfo
};

const std::vector<MethodInfo>& methods();  // best first
const std::vector<AccelerationInfo>& accelerations();
const MethodInfo& info_of(Method method);
const AccelerationInfo& info_of(Acceleration acceleration);
inline const char* name_of(Method method) { return info_of(method).name; }
inline const char* name_of(Acceleration acceleration) { return info_of(acceleration).name; }
inline const char* label_of(Method method) { return info_of(method).label; }
inline const char* label_of(Acceleration acceleration) { return info_of(acceleration).label; }
inline const char* help_of(Method method) { return info_of(method).help; }
inline const char* help_of(Acceleration acceleration) { return info_of(acceleration).help; }

struct SolverChoice {
  Method method;
  Acceleration acceleration;
  bool operator==(const SolverChoice&) const = default;
};

const std::vector<SolverChoice>& solver_choices();  // all sensible ones, best first
std::vector<SolverChoice> i3d2019_choices();        // those of MethodInfo::in_i3d2019, in the same order
/// The best choice with the given names (nullopt: any); none if there is no such choice.
std::optional<SolverChoice> find_choice(std::optional<std::string_view> method,
                                        std::optional<std::string_view> acceleration);
std::string list_of_choices();  // for error messages: "jacobi with none, ..."

/// Whether a solver setting has an effect with this choice: "colors", for instance, only with gauss_seidel.
bool applies(std::string_view setting, const SolverChoice& choice);
bool carries(Method method, MaterialModel model);
/// Why the method cannot run these materials, quadratic elements or contact, as a sentence; empty if it can.
std::string refusal(Method method, const std::vector<Material>& materials, bool quadratic, bool contact = false);
/// Throws Error naming `where` if the method does not support the model of one of the materials.
void require_carried(Method method, const std::vector<Material>& materials, const std::string& where);

}  // namespace fascia
