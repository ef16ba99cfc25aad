#include "api/settings.h"

#include "api/values.h"

namespace fascia::api {

SolverSettings checked(const Settings& settings) {
  const std::optional<SolverChoice> pair = find_choice(settings.method, settings.acceleration);
  if (!pair)
    throw Error("settings", "method \"" + settings.method + "\" with acceleration \"" + settings.acceleration + "\"",
                "expected one of these solver choices: " + list_of_choices());
  const std::optional<Integrator> integrator = find_integrator(settings.integrator);
  if (!integrator)
    throw Error("settings.integrator", "is \"" + settings.integrator + "\"", "expected implicit_euler, bdf2, sdirk2");
  SolverSettings own;
  own.method = pair->method;
  own.acceleration = pair->acceleration;
  own.integrator = *integrator;
  own.iterations = settings.iterations;
  own.tolerance = settings.tolerance;
  own.time_step = settings.time_step;
  own.substeps = settings.substeps;
  own.frame_budget = settings.frame_budget;
  own.colors = settings.colors;
  own.spectral_radius = settings.spectral_radius;
  own.window = settings.window;
  own.rest_speed = settings.rest_speed;
  visit_settings(static_cast<const SolverSettings&>(own), RangeCheck{"settings"});
  return own;
}

Settings shown(const SolverSettings& settings) {
  Settings out;
  out.method = name_of(settings.method);
  out.acceleration = name_of(settings.acceleration);
  out.integrator = name_of(settings.integrator);
  out.iterations = settings.iterations;
  out.tolerance = settings.tolerance;
  out.time_step = settings.time_step;
  out.substeps = settings.substeps;
  out.frame_budget = settings.frame_budget;
  out.colors = settings.colors;
  out.spectral_radius = settings.spectral_radius;
  out.window = settings.window;
  out.rest_speed = settings.rest_speed;
  return out;
}

std::vector<std::pair<std::string, std::string>> solver_pairs() {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const SolverChoice& pair : solver_choices())
    pairs.emplace_back(name_of(pair.method), name_of(pair.acceleration));
  return pairs;
}

}  // namespace fascia::api
