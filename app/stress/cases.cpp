// The groups of the stress suite, each in the file of its name.
#include "app/stress/case_maker.h"
#include "base/error.h"

namespace fascia {

using AddCases = void(StressCases& c);
AddCases add_starts, add_numbers, add_conservation, add_meshes, add_handling, add_standing, add_slender, add_contact,
    add_bodies, add_tangles;

bool can_run(Method method, MaterialModel model, ElementOrder elements) {
  Material material;
  material.model = model;
  return refusal(method, {material}, elements == ElementOrder::quadratic).empty();
}

std::vector<StressCase> stress_cases(const SolverChoice& pair, MaterialModel model, Integrator integrator,
                                     ElementOrder elements, const std::filesystem::path& folder, bool quick) {
  std::error_code ec;
  std::filesystem::create_directories(folder / "meshes", ec);
  if (ec) throw Error((folder / "meshes").string(), "cannot be made: " + ec.message(), "expected a writable folder");
  StressCases c{pair, model, integrator, elements, folder, quick};
  for (AddCases* add : {add_starts, add_numbers, add_conservation, add_meshes, add_handling, add_standing, add_slender,
                        add_contact, add_bodies, add_tangles})
    add(c);
  return std::move(c.cases);
}

}  // namespace fascia
