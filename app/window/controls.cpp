#include "app/window/controls.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>

#include "base/error.h"

namespace fascia {
namespace {

constexpr double kResize = 1.1;  // factor of a grab's patch radius, per key press

// Returns the key by its letter, because the position of letters such as Z depends on the keyboard layout.
int letter_of(int key) {
  const char* name = glfwGetKeyName(key, 0);
  return name && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0 ? name[0] - 'a' + GLFW_KEY_A : key;
}

MouseTool::Button button_of(int code) {
  return code == GLFW_MOUSE_BUTTON_LEFT    ? MouseTool::Button::left
         : code == GLFW_MOUSE_BUTTON_RIGHT ? MouseTool::Button::right
                                           : MouseTool::Button::middle;
}

MouseTool::Keys keys_of(int mods) {
  return {(mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_ALT) != 0};
}

bool any_popup() { return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }

}  // namespace

void Controls::note_panels() { panels_take_escape_ = ImGui::IsAnyItemActive() || any_popup(); }

void Controls::handle(Requests& requests) {
  using Kind = InputEvent::Kind;
  const ImGuiIO& io = ImGui::GetIO();
  for (InputEvent event : input_.take()) {
    const bool taken =
        event.kind == Kind::press && !io.WantCaptureMouse && !stage_.mouse.dragging() && !stage_.hand.dragging();
    const MouseTool::Picture picture = sides_.to_side(event.at, taken);
    Session& held = sides_.held();
    switch (event.kind) {
      case Kind::press:
        if (!io.WantCaptureMouse && event.code <= GLFW_MOUSE_BUTTON_MIDDLE) press_button(event, picture);
        break;
      case Kind::release:
        if (event.code == GLFW_MOUSE_BUTTON_LEFT) end_brush({picture.width, picture.height}, requests);
        stage_.mouse.release(button_of(event.code), keys_of(event.mods), held, stage_.state.grab);
        if (event.code == hand_button_) stage_.hand.release();
        break;
      case Kind::move:
        stage_.stroke.move(event.at, {picture.width, picture.height}, held, brush_radius());
        stage_.lasso.move(event.at);
        stage_.mouse.move(event.at, picture, held);
        stage_.hand.move(event.at, {picture.width, picture.height}, held);
        break;
      case Kind::scroll:
        if (!io.WantCaptureMouse && !scroll_instrument(event) &&
            !stage_.mouse.scroll(event.scroll.y(), keys_of(event.mods), held, stage_.state.grab))
          held.camera.zoom(std::pow(0.9, event.scroll.y()));
        break;
      case Kind::key:
        if (takes_key(event.code)) press_key(event.code, event.mods, requests);
        break;
      case Kind::drop:
        if (!event.files.empty()) requests.open = event.files.front();
        break;
      case Kind::key_up:
        if (event.code == GLFW_KEY_G) stage_.hand.stop_jaws(held);
        break;
      case Kind::text:
        break;
    }
    take_over_replay();
    sides_.after_mouse();
  }
}

// With Shift or Alt the mouse acts on tissue and view with an instrument in hand, too. A click on another instrument
// takes that one in hand.
bool Controls::take_instrument(const InputEvent& event, MouseTool::Picture picture) {
  constexpr int kOfTissue = GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_CONTROL;
  InstrumentHand& hand = stage_.hand;
  const bool left = event.code == GLFW_MOUSE_BUTTON_LEFT, right = event.code == GLFW_MOUSE_BUTTON_RIGHT;
  if (event.mods & kOfTissue || !(left || right) || stage_.mouse.dragging() || hand.dragging()) return false;
  if (left)
    if (const auto seen = InstrumentHand::at(event.at, {picture.width, picture.height}, sides_.held())) hand.pick(seen);
  if (!hand.picked()) return false;
  hand.press(left ? InstrumentHand::Drag::shift : InstrumentHand::Drag::turn, event.at);
  hand_button_ = event.code;
  return true;
}

bool Controls::scroll_instrument(const InputEvent& event) {
  if (!stage_.hand.picked() || stage_.mouse.dragging() || event.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT)) return false;
  stage_.hand.scroll(event.scroll.y(), sides_.held());
  return true;
}

void Controls::take_over_replay() {
  if (stage_.hand.commands() && stage_.simulation().replaying()) recording_.take_over_replay();
}

double Controls::brush_radius() const { return stage_.state.grab.radius * stage_.session->look.radius; }

// With Shift or Alt the mouse grabs, pushes or orbits with a brush in hand, too.
bool Controls::begin_brush(const InputEvent& event, BrushedPicture picture) {
  const BrushSettings& brush = stage_.state.brush;
  if (!brush.in_hand() || sides_.split() || event.mods & (GLFW_MOD_SHIFT | GLFW_MOD_ALT)) return false;
  if (!brush.lasso)
    return stage_.stroke.begin(event.at, picture, *stage_.session,
                               brush.of_tets() ? Stroke::Marks::tets : Stroke::Marks::vertices, brush_radius());
  stage_.lasso.begin(event.at);
  return true;
}

void Controls::end_brush(BrushedPicture picture, Requests& requests) {
  if (!stage_.stroke.under_way() && !stage_.lasso.drawing()) return;
  BrushSettings& brush = stage_.state.brush;
  Session& session = *stage_.session;
  std::vector<std::uint32_t> marked = stage_.stroke.finish();
  if (const std::vector<Eigen::Vector2d> curve = stage_.lasso.finish(); !curve.empty()) {
    const auto depth = brush.through ? std::nullopt : std::optional(brush.depth * session.look.radius);
    marked = brush.of_tets() ? tets_within(curve, picture, session, depth) : vertices_within(curve, picture, session);
  }
  const Scene& scene = session.simulation.scene;
  const Model& model = session.simulation.model;
  if (brush.of_tets()) {
    const std::string region = brush.brush == Brush::paint ? brush.painted_region() : "";
    if (region == "default" || (region.empty() && brush.brush == Brush::paint))
      throw Error("The new region", "has no name", "type one that is not default");
    const Painting wanted = with_painted(scene, model, marked, region, brush.fresh_material());
    if (wanted == painting_of(scene, model)) return;
    requests.painting = wanted;
    if (brush.brush == Brush::paint) brush.region = region;  // the next stroke continues it
  } else {
    const FixedSets wanted = with_fixed(scene, model, marked, brush.brush == Brush::fix);
    if (wanted != fixed_of(scene)) requests.fixed = wanted;
  }
}

void Controls::press_button(const InputEvent& event, MouseTool::Picture picture) {
  const bool left = event.code == GLFW_MOUSE_BUTTON_LEFT;
  if (left && !sides_.split() && observer_.choose_probe(event.at)) return;
  if (left && begin_brush(event, {picture.width, picture.height})) return;
  if (take_instrument(event, picture)) return;
  if (left && event.mods & GLFW_MOD_CONTROL && stage_.session->display().section)
    stage_.mouse.press_section(button_of(event.code), event.at);
  else
    stage_.mouse.press(button_of(event.code), keys_of(event.mods), event.at, picture, sides_.held(), stage_.state.grab);
  if (!stage_.mouse.grabs().all().empty() && stage_.simulation().replaying()) recording_.take_over_replay();
}

// While the panels show a keyboard cursor, its keys belong to them; text input always does.
bool Controls::takes_key(int key) const {
  const ImGuiIO& io = ImGui::GetIO();
  const bool of_cursor =
      key == GLFW_KEY_TAB || key == GLFW_KEY_SPACE || key == GLFW_KEY_ENTER || key == GLFW_KEY_ESCAPE;
  return !io.WantTextInput && !(panels_take_escape_ && key == GLFW_KEY_ESCAPE) && !(io.NavVisible && of_cursor);
}

void Controls::press_with_control(int key, bool shift, Requests& requests) {
  const UndoHistory& history = stage_.state.history;
  switch (letter_of(key)) {
    case GLFW_KEY_Z:
      if (shift ? history.can_redo() : history.can_undo()) requests.history = history.done() + (shift ? 1 : -1);
      break;
    case GLFW_KEY_Y:
      if (history.can_redo()) requests.history = history.done() + 1;
      break;
    case GLFW_KEY_C:
      requests.copy_command |= shift;
      break;
    case GLFW_KEY_O:
      (shift ? requests.recent : requests.open_dialog) = true;
      break;
    case GLFW_KEY_E:
      requests.export_dialog = true;
      break;
    case GLFW_KEY_S:
      requests.save_dialog = true;
      break;
    case GLFW_KEY_R:
      requests.save_replay_dialog = true;
      break;
    case GLFW_KEY_Q:
      requests.close = true;
      break;
  }
}

void Controls::press_key(int key, int mods, Requests& requests) {
  if (any_popup()) return;  // a dialog is open
  const bool shift = mods & GLFW_MOD_SHIFT;
  if (mods & GLFW_MOD_CONTROL) return press_with_control(key, shift, requests);
  WindowState& state = stage_.state;
  MouseTool& mouse = stage_.mouse;
  Session& held = sides_.held();
  switch (key) {
    case GLFW_KEY_F:
      requests.frame_view = true;
      break;
    case GLFW_KEY_SPACE:
      state.paused = !state.paused;
      break;
    case GLFW_KEY_PERIOD:
      requests.step = true;
      break;
    case GLFW_KEY_R:
      requests.reset = true;
      break;
    case GLFW_KEY_W: {
      DisplaySettings display = stage_.session->display();
      display.wireframe = !display.wireframe;
      stage_.session->set_display(display);
      break;
    }
    case GLFW_KEY_H:
      state.show_panels = !state.show_panels;
      break;
    case GLFW_KEY_P:
      requests.screenshot = true;
      break;
    case GLFW_KEY_B:
      requests.compare = CompareAsk::open_or_close;
      break;
    case GLFW_KEY_V:
      if (shift)
        state.show_recording = !state.show_recording;
      else
        requests.video = true;
      break;
    case GLFW_KEY_T:
      mouse.stay();
      break;
    case GLFW_KEY_TAB:
      stage_.hand.pick_next(stage_.simulation());
      break;
    case GLFW_KEY_G:
      stage_.hand.move_jaws(shift ? 0 : 1, held);
      break;
    case GLFW_KEY_X:
      state.grab.push = !state.grab.push;
      break;
    case GLFW_KEY_LEFT_BRACKET:
      mouse.resize(1 / kResize, held, state.grab);
      break;
    case GLFW_KEY_RIGHT_BRACKET:
      mouse.resize(kResize, held, state.grab);
      break;
    case GLFW_KEY_DELETE:
      mouse.let_go(sides_.pointer_in_side(sides_.grab_in_b()), sides_.picture_of_grab(), held);
      break;
    case GLFW_KEY_ESCAPE:
      if (state.show_help || state.show_recording || state.show_gallery)
        state.show_help = state.show_recording = state.show_gallery = false;
      else if (stage_.stroke.under_way() || stage_.lasso.drawing())
        stage_.give_up_brush();
      else if (state.brush.in_hand())
        state.brush.brush = Brush::off;
      else if (stage_.hand.picked())
        stage_.hand.pick(std::nullopt);
      else
        mouse.let_go_staying(held);
      break;
    case GLFW_KEY_F1:
      state.show_help = !state.show_help;
      break;
    case GLFW_KEY_F2:
      state.show_gallery = !state.show_gallery;
      break;
    case GLFW_KEY_F3:
      state.plots.shown = !state.plots.shown;
      stage_.diagnose = true;  // the plots need a point
      break;
    case GLFW_KEY_F5:
      requests.reload_shaders = true;
      break;
  }
}

}  // namespace fascia
