// A scene at other values of its free parameters.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "sim/fit/parameter.h"
#include "sim/model/model.h"

namespace fascia {

/// The scene with these values at their keys. Throws Error "--free KEY: ..." for an unknown key and a value out of its
/// range.
Scene with_values(const Scene& scene, const std::vector<std::pair<std::string, double>>& values);

class TunedScene {
 public:
  /// Throws Error for a parameter that changes nothing that is simulated.
  TunedScene(Scene scene, Model model, std::vector<Parameter> parameters);

  struct Built {
    Scene scene;
    Model model;
  };
  /// At these inner coordinates [parameter]. Meshes are read again only where a parameter is no material, gravity, grab
  /// or prescribed motion. Throws Error.
  Built at(const std::vector<double>& inner) const;

  const Scene& scene() const { return scene_; }
  const Model& model() const { return model_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  std::vector<double> start() const;  // inner
  /// Whether the parameter leaves mesh and constraints as they are, so that an equilibrium has a tangent
  /// (sim/reference/tangent/static_tangent.h).
  bool is_smooth(std::size_t parameter) const { return kinds_[parameter] != Kind::other; }

 private:
  enum class Kind { material, other, load };

  Scene scene_;
  Model model_;
  std::vector<Parameter> parameters_;
  std::vector<Kind> kinds_;  // [parameter]
};

}  // namespace fascia
