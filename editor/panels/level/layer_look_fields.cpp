#include "layer_look_fields.h"

#include <imgui_internal.h>

#include <array>
#include <cmath>
#include <utility>

#include "edit/group_tools.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/emit_edit.h"
#include "panels/ui/shown_text.h"
#include "panels/ui/ui.h"

namespace talus {
namespace {

constexpr float kNumber = 72;  // px at scale 1, of a field for a number

}  // namespace

float LayerLookFields::height(const Ui& ui) {
  return 3 * (ui.px(theme::kButton) + ImGui::GetStyle().ItemSpacing.y);
}

LayerLooks LayerLookFields::looks_in(const Level& level) const {
  return group_ >= 0 ? looks_of_group(level, group_) : looks_of(level, layer_);
}

void LayerLookFields::draw(const LayerInOrder& layer, int group, const Session& session, Actions& actions,
                           Ui& ui) {
  layer_ = layer;
  group_ = group;
  const LayerLooks looks = looks_in(session.level());
  ui.begin_row();
  draw_opacity(looks, session, actions, ui);
  ImGui::SameLine();
  draw_tint(looks, session, actions, ui);
  ImGui::SameLine();
  const std::string name =
      group >= 0 ? group_name(session.level(), group) : layer_text(session.level(), layer);
  draw_short_text("of " + name, std::max(0.0f, ImGui::GetContentRegionAvail().x), theme::tone(theme::kMuted));
  draw_pair("offset", &LayerLooks::offset, 1,
            group >= 0        ? "px by which all layers of the group are moved; the ground of tiles stays."
            : layer.has_tiles ? "px by which the layer's picture is moved; its ground stays."
                              : "px by which all that is in the layer is moved, also its ground.",
            session, actions, ui);
  draw_pair("parallax", &LayerLooks::parallax, 0.01f,
            "By how much the picture moves with the camera in the play view: 1 as the ground, 0 not "
            "at all.",
            session, actions, ui);
  ui.end_row();
}

void LayerLookFields::draw_pair(const std::string& label, Vec2 LayerLooks::*pair, float speed,
                                const char* help, const Session& session, Actions& actions, Ui& ui) {
  LayerLooks looks = looks_in(session.level());
  Vec2& value = looks.*pair;
  ui.field_label(label);
  const std::string names[] = {"layers/" + label + "_x", "layers/" + label + "_y"};
  bool changed =
      draw_number_field({names[0], "x %.6g", help, kNumber, speed}, value.x, session, number_edit_, ui);
  ImGui::SameLine();
  changed |=
      draw_number_field({names[1], "y %.6g", help, kNumber, speed}, value.y, session, number_edit_, ui);
  if (changed) change(looks, number_edit_.stroke, session, actions);
}

void LayerLookFields::draw_opacity(LayerLooks looks, const Session& session, Actions& actions, Ui& ui) {
  ui.field_label("opacity");
  int percent = static_cast<int>(std::lround(looks.opacity * 100));
  ImGui::SetNextItemWidth(ui.px(kNumber));
  const bool changed = ImGui::SliderInt("##opacity", &percent, 0, 100, "%d %%", ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemActivated()) {
    opacity_stroke_ = session.next_stroke();
    opacity_before_ = looks.opacity;
  }
  const bool cancelled = ImGui::IsItemActive() && is_drag_cancelled();
  if (cancelled) ImGui::ClearActiveID();
  ui.item("layers/opacity", "How opaque the layer or the group is drawn.", "Ctrl+click types a number");
  if (!changed && !cancelled) return;
  looks.opacity = cancelled ? opacity_before_ : percent / 100.0;
  change(looks, opacity_stroke_, session, actions);
}

void LayerLookFields::draw_tint(LayerLooks looks, const Session& session, Actions& actions, Ui& ui) {
  ui.label("tint");
  ImGui::SameLine();
  std::array<float, 3> color = {static_cast<float>(looks.tint.r) / 255,
                                static_cast<float>(looks.tint.g) / 255,
                                static_cast<float>(looks.tint.b) / 255};
  const bool changed = ImGui::ColorEdit3("##tint", color.data(),
                                         ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoInputs);
  // Each press begins another undo, also in the window that the colour opens.
  if (ImGui::IsItemActivated() || ImGui::IsMouseClicked(0)) tint_stroke_ = session.next_stroke();
  ui.item("layers/tint", "A colour that multiplies those of the layer or the group; white changes nothing.");
  if (!changed) return;
  const auto byte = [](float part) { return static_cast<std::uint8_t>(std::lround(part * 255)); };
  looks.tint = {byte(color[0]), byte(color[1]), byte(color[2])};
  change(looks, tint_stroke_, session, actions);
}

void LayerLookFields::change(const LayerLooks& looks, int stroke, const Session& session,
                             Actions& actions) const {
  emit_edit(actions,
            group_ >= 0 ? set_looks_of_group(session.level(), group_, looks)
                        : set_looks(session.level(), layer_, looks),
            stroke);
}

}  // namespace talus
