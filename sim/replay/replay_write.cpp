// Writes replays as text: a line per input, each number with the digits that read back to it.
#include "base/file.h"
#include "base/json/json_write.h"
#include "sim/replay/replay.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector3d;

Json list_of(const std::vector<Vector3d>& vectors) {
  Json list = Json::array();
  for (const Vector3d& v : vectors) list.push_back(vector_document(v));
  return list;
}

Json list_of(const ContactMemory& contact) {
  Json list = Json::array();
  for (std::size_t row = 0; row < contact.size(); ++row)
    if (const ContactForce& force = contact[row]; force != ContactForce{})
      list.push_back({row, force.normal, force.friction.x(), force.friction.y(), force.friction.z()});
  return list;
}

Json document_of(const GrabInput& springs) {
  Json list = Json::array();
  for (const GrabSpring& s : springs) {
    list.push_back({s.vertex, s.target.x(), s.target.y(), s.target.z(), s.stiffness});
    if (s.grab != 0) list.back().push_back(s.grab);
  }
  return list;
}

Json document_of(const GrabMove& move) {
  Json list = Json::array();
  for (const GrabMove::Part& p : move.parts) list.push_back({p.count, p.offset.x(), p.offset.y(), p.offset.z()});
  return list;
}

Json document_of(const InstrumentInput& led) {
  return {{"name", led.name},
          {"position", vector_document(led.place.position)},
          {"rotate_deg", vector_document(led.place.rotate_deg)},
          {"grip", led.place.grip}};
}

std::string line_of(const Json& document) {
  return document.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string replay_line(const Input& input) {
  Json object{{"step", input.step}};
  struct Writer {
    Json& object;
    void operator()(const SolverSettings& settings) { object["solver"] = solver_document(settings); }
    void operator()(const MaterialInput& m) {
      object["material"] = {{"index", m.index}, {"values", material_document(m.material)}};
    }
    void operator()(const GravityInput& g) { object["gravity"] = vector_document(g.gravity); }
    void operator()(const GrabInput& springs) { object["grab"] = document_of(springs); }
    void operator()(const GrabMove& move) { object["move"] = document_of(move); }
    void operator()(const InstrumentInput& led) { object["instrument"] = document_of(led); }
    void operator()(const GrantInput& grant) { object["iterations"] = grant.iterations; }
    void operator()(const BackgroundInput& background) { object["background"] = background.results; }
    void operator()(const ResetInput& reset) { object["reset"] = reset.to_rest ? "rest" : "start"; }
    void operator()(const RestoreInput&) { object["sound"] = true; }
    void operator()(const CameraSettings& camera) { object["camera"] = camera_document(camera); }
    void operator()(const DisplaySettings& display) { object["display"] = display_document(display); }
  };
  std::visit(Writer{object}, input.change);
  return line_of(object);
}

std::string replay_steps_line(long steps, std::optional<std::uint64_t> hash) {
  Json object{{"steps", steps}};
  if (hash) object["hash"] = hash_text(*hash);
  return line_of(object);
}

std::string replay_header(const Replay& replay, const std::filesystem::path& folder) {
  Json header{{"fascia_replay", 2}};
  for (const auto& [keyword, text] : replay.made_by) header["made_by"][keyword] = text;
  header["scene"] = complete_document(replay.scene, folder);
  if (replay.start) {
    header["start"] = {{"time", replay.start->time},
                       {"displacement", list_of(replay.start->displacement)},
                       {"velocity", list_of(replay.start->velocity)}};
    if (const State::Earlier& earlier = replay.start->earlier; earlier.step > 0)
      header["start"]["earlier"] = {{"step", earlier.step},
                                    {"displacement", list_of(earlier.displacement)},
                                    {"velocity", list_of(earlier.velocity)}};
    if (const ContactMemory& contact = replay.start->contact; !contact.empty())
      header["start"]["contact"] = {{"rows", contact.size()}, {"forces", list_of(contact)}};
    for (const InstrumentInput& led : replay.start->led) header["start"]["instruments"].push_back(document_of(led));
  }
  header["timed"] = replay.timed;
  return line_of(header);
}

std::string replay_to_json(const Replay& replay, const std::filesystem::path& folder) {
  std::string text = replay_header(replay, folder);
  for (const Input& input : replay.inputs) text += replay_line(input);
  return text + replay_steps_line(replay.steps, replay.hash);
}

void write_replay(const std::filesystem::path& path, const Replay& replay) {
  write_file(path, replay_to_json(replay, path.parent_path()));
}

}  // namespace fascia
