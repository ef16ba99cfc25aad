#include "app/refine/choice.h"

#include <algorithm>
#include <cmath>

#include "sim/surface/surface_fill.h"

namespace fascia {
namespace {

long cells_of(int resolution, double refinement) { return std::lround(resolution * refinement); }

auto first_with_resolution(const Scene& scene) {
  return std::find_if(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.resolution; });
}

}  // namespace

bool has_resolution(const Scene& scene) { return first_with_resolution(scene) != scene.bodies.end(); }

std::vector<double> refinements_of(const Scene& scene) {
  std::vector<double> refinements = usual_refinements();
  if (!has_resolution(scene)) return refinements;
  const int resolution = *first_with_resolution(scene)->resolution;
  for (double& refinement : refinements)
    refinement = static_cast<double>(cells_of(resolution, refinement)) / resolution;
  refinements.erase(std::unique(refinements.begin(), refinements.end()), refinements.end());
  std::erase_if(refinements, [&](double refinement) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) {
      if (!body.resolution) return false;
      const long cells = cells_of(*body.resolution, refinement);
      return cells < kFewestCells || cells > kMostCells;
    });
  });
  return refinements;
}

std::vector<std::string> sets_of(const Proposal& proposal, const Scene& scene) {
  // A key of bodies on its own means body 0.
  const auto key = [](std::size_t body, const char* name) {
    return (body == 0 ? "" : "bodies." + std::to_string(body) + ".") + std::string(name) + '=';
  };
  std::vector<std::string> sets;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) sets.push_back(key(b, "elements") + name_of(proposal.elements));
  sets.push_back(std::string("solver.integrator=") + name_of(proposal.integrator));
  sets.push_back("solver.substeps=" + std::to_string(proposal.substeps));
  sets.push_back("solver.iterations=" + std::to_string(proposal.iterations));
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (const std::optional<int> resolution = scene.bodies[b].resolution)
      sets.push_back(key(b, "resolution") + std::to_string(cells_of(*resolution, proposal.refinement)));
  return sets;
}

}  // namespace fascia
