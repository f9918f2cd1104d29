// The corner of the play view.
#include "overlay_legend.h"

#include <algorithm>

#include "overlay_painter.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

constexpr int kDimmed = 150;  // alpha of the name of an overlay of which nothing is drawn
constexpr float kLegendSwatch = 14, kLegendPad = 4, kLegendText = 6;  // px at scale 1
// Share of the canvas that names may take: more would hide the level.
constexpr float kMaxWide = 0.34f, kMaxHigh = 0.6f, kMaxOfAll = 0.07f;

float name_line(const Ui& ui) { return ImGui::GetTextLineHeight() + ui.px(2); }

std::vector<const Overlay*> shown_overlays(const Session& session) {
  std::vector<const Overlay*> shown;
  for (const Overlay* overlay : all_overlays()) {
    const bool applies = overlay->applies == nullptr || overlay->applies(session.level());
    if (applies && session.choices().overlays.has(*overlay)) shown.push_back(overlay);
  }
  return shown;
}

float names_width(const std::vector<const Overlay*>& shown, const Ui& ui) {
  float text = 0;
  for (const Overlay* overlay : shown) text = std::max(text, size_of_text(overlay->label).x);
  return text + ui.px(kLegendSwatch) + ui.px(kLegendText) + 2 * ui.px(kLegendPad);
}

}  // namespace

float OverlayLegend::width(const Session& session, const Ui& ui) {
  const auto shown = shown_overlays(session);
  return shown.empty() ? 0 : names_width(shown, ui) + ui.px(kLegendPad);
}

OverlayLegend::OverlayLegend(const Session& session, const CanvasView& view, float top, const Ui& ui)
    : session_(session), ui_(ui), shown_(shown_overlays(session)) {
  const float width = view.max.x - view.min.x, height = view.max.y - view.min.y, pad = ui.px(kLegendPad);
  if (shown_.empty() || height < ui.px(80) || width < ui.px(80)) return;
  const ImVec2 corner{view.max.x - pad, top + pad};
  lay_out_names(corner);
  const float w = box_->max.x - box_->min.x, h = box_->max.y - box_->min.y;
  is_tight_ = w > kMaxWide * width || h > kMaxHigh * height || w * h > kMaxOfAll * width * height;
  has_names_ = !is_tight_ && !ui.view.canvas.legend_folded;
  if (!has_names_) lay_out_swatches(corner, view.max.y - pad - corner.y);
}

void OverlayLegend::lay_out_names(ImVec2 corner) {
  const float height = name_line(ui_) * static_cast<float>(shown_.size()) + 2 * ui_.px(kLegendPad);
  box_ = {{corner.x - names_width(shown_, ui_), corner.y}, {corner.x, corner.y + height}};
}

void OverlayLegend::lay_out_swatches(ImVec2 corner, float room) {
  const float cell = name_line(ui_), pad = ui_.px(kLegendPad);
  const int count = static_cast<int>(shown_.size());
  rows_ = std::clamp(static_cast<int>((room - 2 * pad) / cell), 1, count);
  const int columns = (count + rows_ - 1) / rows_;
  box_ = {{corner.x - 2 * pad - cell * static_cast<float>(columns), corner.y},
          {corner.x, corner.y + 2 * pad + cell * static_cast<float>(rows_)}};
}

void OverlayLegend::draw(ImDrawList& list) const {
  if (!box_) return;
  const float cell = name_line(ui_), swatch = ui_.px(kLegendSwatch), pad = ui_.px(kLegendPad);
  list.AddRectFilled(box_->min, box_->max, theme::color(theme::kDark, theme::kPlateAlpha), ui_.px(3));
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const int n = static_cast<int>(i), row = has_names_ ? n : n % rows_, column = has_names_ ? 0 : n / rows_;
    const ImVec2 at{box_->min.x + pad + cell * static_cast<float>(column),
                    box_->min.y + pad + cell * static_cast<float>(row)};
    paint_overlay_swatch(list, *shown_[i], {at.x, at.y + (cell - swatch) / 2}, swatch,
                         session_.choices().overlay_palette);
    const int alpha = why_nothing(*shown_[i], session_.level()).empty() ? 255 : kDimmed;
    if (has_names_)
      add_text(list, {at.x + swatch + ui_.px(kLegendText), at.y}, theme::color(theme::kMuted, alpha),
               shown_[i]->label);
  }
}

std::string OverlayLegend::help() const {
  std::string names, missing;
  for (const Overlay* overlay : shown_) {
    names.append(names.empty() ? "" : ", ").append(overlay->label);
    if (const auto why = why_nothing(*overlay, session_.level()); !why.empty())
      missing.append("\n").append(why);
  }
  if (has_names_) return "The overlays that are shown. Click to fold their names away." + missing;
  return "Shown: " + names + ". " + (is_tight_ ? "Their names have no room here." : "Click for the names.") +
         missing;
}

bool OverlayLegend::take_mouse(Ui& ui) const {
  if (!box_) return false;
  ui.place("play/legend", box_->min, box_->max);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!ImGui::IsItemHovered() || !ScreenBox{mouse, mouse}.inside(*box_)) return false;
  ui.tooltip(help(), keys_of("canvas/legend"_command, ui));
  if (ImGui::IsMouseClicked(0)) ui.view.canvas.legend_folded = !ui.view.canvas.legend_folded;
  return true;
}

}  // namespace talus
