// Rows with an eye, a lock and the mark of ground; below them, how the chosen layer looks.
#include "layers_panel.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "edit/layer_tools.h"
#include "edit/object_tools.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/commands/commands.h"
#include "panels/ui/long_list.h"

namespace talus {
namespace {

constexpr float kRow = 22;       // px at scale 1, of a layer
constexpr float kLeastRows = 3;  // of the list, however low the panel is
constexpr float kLabel = 62;     // px at scale 1, of the words beside the fields
constexpr float kNumber = 72;    // px at scale 1, of a field for a number

void push(Edit edit, Actions& actions, int stroke = 0) {
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), stroke});
}

const TileLayer& looks_of(const Session& session, int layer) {
  return session.level().layers.list[static_cast<std::size_t>(layer)];
}

struct LayerMark {
  bool TileLayer::*field;
  const char* name;  // of its widget
  Icon on, off;
  const char* help;
};
constexpr std::array<LayerMark, 3> kMarks = {
    {{&TileLayer::visible, "eye", Icon::eye, Icon::eye_closed,
      "Whether the layer is drawn. Hidden ground stops bodies, too."},
     {&TileLayer::locked, "lock", Icon::lock, Icon::unlock,
      "Whether the layer is locked, so that no tool changes its tiles."},
     {&TileLayer::is_ground, "ground", Icon::ground, Icon::ground,
      "Whether tiles of the layer are ground and bodies, or only drawn."}}};

// A mark that a click switches, without the frame of a button, as each row has three. Returns whether it was
// clicked.
bool draw_switch(const char* name, Icon icon, bool on, const Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ui.px(kRow), inset = ui.px(4);
  const bool clicked = ImGui::InvisibleButton(name, {side, side});
  const ImU32 color = ImGui::IsItemHovered() ? theme::tone(theme::kAccent)
                      : on                   ? theme::tone(theme::kText)
                                             : theme::tone(theme::kMuted, 90);
  draw_icon(*ImGui::GetWindowDrawList(), icon, {at.x + inset, at.y + inset}, side - 2 * inset, color);
  return clicked;
}

void draw_mark(const LayerMark& mark, int layer, const Session& session, Actions& actions, Ui& ui) {
  const TileLayer& looks = looks_of(session, layer);
  const bool on = looks.*mark.field;
  if (draw_switch(mark.name, on ? mark.on : mark.off, on, ui)) {
    TileLayer switched = looks;
    switched.*mark.field = !on;
    push(set_layer_looks(session.level(), layer, std::move(switched)), actions);
  }
  ui.item("layers/" + std::to_string(layer) + "/" + mark.name, mark.help);
}

void draw_object_layer(int layer, const Session& session, Actions& actions, Ui& ui) {
  const ObjectLayer& objects = session.level().objects[static_cast<std::size_t>(layer)];
  const std::string id = "layers/objects/" + std::to_string(layer);
  const bool visible = objects.visible, is_ground = objects.is_ground;
  if (draw_switch("eye", visible ? Icon::eye : Icon::eye_closed, visible, ui))
    push(set_object_visible(session.level(), layer, !visible), actions);
  ui.item(id + "/eye", "Whether the objects are drawn. Hidden ground stops bodies, too.");
  ImGui::SameLine(0, ui.px(kRow));  // no object is locked
  if (draw_switch("ground", Icon::ground, is_ground, ui))
    push(set_object_ground(session.level(), layer, !is_ground), actions);
  ui.item(id + "/ground", "Whether areas and lines among the objects are ground, or only drawn.");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  draw_text("  " + object_layer_text(session.level(), layer));
  ui.item(id, "A layer of objects of the map.");
}

void draw_layer_label(const char* text, Ui& ui) {
  const float x = ImGui::GetCursorPosX();
  ui.label(text);
  ImGui::SameLine();
  ImGui::SetCursorPosX(x + ui.px(kLabel));
}

}  // namespace

void LayersPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (const auto asked = ui.view.requests.take<request::RenameLayer>())
    renaming_ = Renaming{asked->layer, looks_of(session, session.level().layers.chosen).name};
  constexpr std::array kButtons = {"layers/add"_command,        "layers/duplicate"_command,
                                   "layers/forwards"_command,   "layers/backwards"_command,
                                   "layers/merge_down"_command, "layers/delete"_command};
  for (const CommandId id : kButtons) {
    command_button(id, session, actions, ui, std::string(id.text) + "_button");
    ImGui::SameLine();
  }
  ImGui::NewLine();
  ImGui::BeginChild("layers");
  draw_object_layers(session, actions, ui);
  draw_list(session, actions, ui);
  draw_looks(session, actions, ui);
  ImGui::EndChild();
}

// Above the layers of tiles.
void LayersPanel::draw_object_layers(const Session& session, Actions& actions, Ui& ui) {
  const std::size_t count = session.level().objects.size();
  if (count == 0) return;
  const float rows = std::min(static_cast<float>(count), kLeastRows);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("objects", {0, rows * ui.px(kRow)});
  draw_rows(static_cast<int>(count), [&](int at) {
    const int layer = static_cast<int>(count) - 1 - at;
    ImGui::PushID(layer);
    draw_object_layer(layer, session, actions, ui);
    ImGui::PopID();
  });
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void LayersPanel::draw_list(const Session& session, Actions& actions, Ui& ui) {
  const int count = session.level().layers.count(), chosen = session.level().layers.chosen;
  const float row = ui.px(kRow), looks = 3 * (ui.px(theme::kButton) + ImGui::GetStyle().ItemSpacing.y);
  const float room = ImGui::GetContentRegionAvail().y - looks;
  const float height =
      std::min(static_cast<float>(count), std::max(kLeastRows, std::floor(room / row))) * row;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("list", {0, height});
  if (std::exchange(followed_, chosen) != chosen) {
    const float top = static_cast<float>(count - 1 - chosen) * row;
    if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
    if (top + row > ImGui::GetScrollY() + height) ImGui::SetScrollY(top + row - height);
  }
  const ImVec2 top = ImGui::GetCursorScreenPos();
  draw_rows(count, [&](int at) {
    const int layer = count - 1 - at;
    ImGui::PushID(layer);
    draw_layer(layer, session, actions, ui);
    ImGui::PopID();
  });
  drag_layer(top, row, session, actions, ui);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void LayersPanel::draw_layer(int layer, const Session& session, Actions& actions, Ui& ui) {
  for (const LayerMark& mark : kMarks) {
    draw_mark(mark, layer, session, actions, ui);
    ImGui::SameLine();
  }
  if (renaming_ && renaming_->layer == layer)
    draw_name_field(layer, session, actions, ui);
  else
    draw_name(layer, session, actions, ui);
}

// A click chooses the layer, a double click renames it, and a drag moves it.
void LayersPanel::draw_name(int layer, const Session& session, Actions& actions, Ui& ui) {
  const bool hidden = !looks_of(session, layer).visible;
  if (hidden) ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kMuted));
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0, 0.5f));
  const bool clicked =
      selectable("  " + layer_name(session.level(), layer), "name", layer == session.level().layers.chosen,
                 ImGuiSelectableFlags_AllowDoubleClick, {0, ui.px(kRow)});
  ImGui::PopStyleVar();
  if (hidden) ImGui::PopStyleColor();
  ui.item("layers/" + std::to_string(layer),
          "A click chooses the layer for the tools. A double click renames it, and a drag moves it.",
          keys_of("layers/above"_command, ui) + ", " + keys_of("layers/below"_command, ui));
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0)) dragged_ = layer;
  if (!clicked || dragged_) return;
  actions.push_back(action::ChooseLayer{layer});
  if (ImGui::IsMouseDoubleClicked(0)) renaming_ = Renaming{layer, looks_of(session, layer).name};
}

// The typed text becomes the name when the field is left; Escape leaves the name as it was.
void LayersPanel::draw_name_field(int layer, const Session& session, Actions& actions, Ui& ui) {
  if (!renaming_->has_keys) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  input_text("renamed", "no name", renaming_->name, ImGuiInputTextFlags_AutoSelectAll);
  ui.item("layers/name", "The layer's name.", "Esc cancels");
  if (ImGui::IsItemActive()) renaming_->has_keys = true;
  if (!ImGui::IsItemDeactivated()) return;
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    TileLayer looks = looks_of(session, layer);
    looks.name = renaming_->name;
    push(set_layer_looks(session.level(), layer, std::move(looks)), actions);
  }
  renaming_.reset();
}

// A line shows where the dragged layer would go. top: of the first row; row: its height; px of the screen.
void LayersPanel::drag_layer(ImVec2 top, float row, const Session& session, Actions& actions, const Ui& ui) {
  if (!dragged_) return;
  const int count = session.level().layers.count(), layer = *dragged_;
  const float y = (ImGui::GetIO().MousePos.y - top.y) / row;
  const int gap = std::clamp(static_cast<int>(std::floor(y + 0.5f)), 0, count);  // above that row
  if (is_drag_cancelled() || layer >= count) {
    ImGui::ClearActiveID();
    dragged_.reset();
    return;
  }
  const float line = top.y + static_cast<float>(gap) * row, half = ui.px(1);
  ImGui::GetWindowDrawList()->AddRectFilled(
      {top.x, line - half}, {top.x + ImGui::GetWindowWidth(), line + half}, theme::tone(theme::kAccent));
  if (ImGui::IsMouseDown(0)) return;
  dragged_.reset();
  const int from = count - 1 - layer, to = gap > from ? gap - 1 : gap;
  push(move_layer(session.level(), layer, count - 1 - to), actions);
}

void LayersPanel::draw_looks(const Session& session, Actions& actions, Ui& ui) {
  const int layer = session.level().layers.chosen;
  TileLayer looks = looks_of(session, layer);
  const auto numbers = [&](const char* label, Vec2& value, const std::string& name, float speed,
                           const char* help) {
    draw_layer_label(label, ui);
    const std::string names[] = {"layers/" + name + "_x", "layers/" + name + "_y"};
    bool changed =
        draw_number_field({names[0], "x %.6g", help, kNumber, speed}, value.x, session, number_edit_, ui);
    ImGui::SameLine();
    changed |=
        draw_number_field({names[1], "y %.6g", help, kNumber, speed}, value.y, session, number_edit_, ui);
    if (changed) push(set_layer_looks(session.level(), layer, looks), actions, number_edit_.stroke);
  };
  ui.begin_row();
  draw_opacity(looks, session, actions, ui);
  ImGui::SameLine();
  draw_tint(looks, session, actions, ui);
  numbers("offset", looks.offset, "offset", 1, "px by which the layer's picture is moved; its ground stays.");
  numbers("parallax", looks.parallax, "parallax", 0.01f,
          "By how much the layer's picture moves with the camera in the play view: 1 as the ground, 0 not at "
          "all.");
  ui.end_row();
}

void LayersPanel::draw_opacity(TileLayer& looks, const Session& session, Actions& actions, Ui& ui) {
  draw_layer_label("opacity", ui);
  int percent = static_cast<int>(std::lround(looks.opacity * 100));
  ImGui::SetNextItemWidth(ui.px(kNumber));
  const bool changed = ImGui::SliderInt("##opacity", &percent, 0, 100, "%d %%", ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemActivated()) {
    opacity_stroke_ = session.next_stroke();
    opacity_before_ = looks.opacity;
  }
  const bool cancelled = ImGui::IsItemActive() && is_drag_cancelled();
  if (cancelled) ImGui::ClearActiveID();
  ui.item("layers/opacity", "How opaque the layer is drawn.", "Ctrl+click types a number");
  if (!changed && !cancelled) return;
  looks.opacity = cancelled ? opacity_before_ : percent / 100.0;
  push(set_layer_looks(session.level(), session.level().layers.chosen, looks), actions, opacity_stroke_);
}

void LayersPanel::draw_tint(TileLayer& looks, const Session& session, Actions& actions, Ui& ui) {
  ui.label("tint");
  ImGui::SameLine();
  std::array<float, 3> color = {static_cast<float>(looks.tint.r) / 255,
                                static_cast<float>(looks.tint.g) / 255,
                                static_cast<float>(looks.tint.b) / 255};
  const bool changed = ImGui::ColorEdit3("##tint", color.data(),
                                         ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoInputs);
  // Each press begins another undo, also in the window that the colour opens.
  if (ImGui::IsItemActivated() || ImGui::IsMouseClicked(0)) tint_stroke_ = session.next_stroke();
  ui.item("layers/tint", "A colour that multiplies those of the layer; white changes nothing.");
  if (!changed) return;
  const auto byte = [](float part) { return static_cast<std::uint8_t>(std::lround(part * 255)); };
  looks.tint = {byte(color[0]), byte(color[1]), byte(color[2])};
  push(set_layer_looks(session.level(), session.level().layers.chosen, looks), actions, tint_stroke_);
}

}  // namespace talus
