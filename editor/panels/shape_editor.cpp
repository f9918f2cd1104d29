// Kind, heights, width and sides of a shape.
#include "shape_editor.h"

#include <array>
#include <string>

#include "edit/tile_shapes.h"

namespace talus {
namespace {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

constexpr std::array<Kind, 4> kChoices = {Kind::none, Kind::solid, Kind::slope, Kind::profile};
constexpr double kLowest = 0, kHighest = kMaxShapeTiles * kTileSide;
constexpr int kLeastTiles = 1, kMostTiles = kMaxShapeTiles;
constexpr float kKindWidth = 132;   // px at scale 1, of the list of kinds
constexpr float kCheckWidth = 88;   // px at scale 1, of a check box
constexpr float kHeightWidth = 32;  // px at scale 1, of one height of a profile

std::string_view label_of(Kind kind) {
  constexpr std::array<std::string_view, 4> kLabels = {"none", "solid", "slope", "profile"};
  return kLabels[static_cast<std::size_t>(kind)];
}

std::string named_part(std::string_view name, std::string_view part) {
  return std::string(name) + "_" + std::string(part);
}

class ShapeFields {
 public:
  ShapeFields(std::string_view name, const TileShape& shape, const Session& session, int& stroke, Ui& ui)
      : name_(name), shape_(shape), session_(session), stroke_(stroke), ui_(ui) {}

  bool draw() {
    if (shape_.kind == Kind::none) return false;
    if (shape_.kind != Kind::solid) {
      if (shape_.kind == Kind::slope)
        draw_slope();
      else
        draw_profile();
      draw_width();
      bool hangs = shape_.side == Side::ceiling;
      ui_.same_line_if_fits(ui_.px(kCheckWidth));
      check("ceiling", "ceiling", hangs, "The ground hangs above the line, and is measured downwards.");
      shape_.side = hangs ? Side::ceiling : Side::floor;
    }
    if (shape_.kind != Kind::solid) ui_.same_line_if_fits(ui_.px(kCheckWidth));
    check("one_way", "one-way", shape_.one_way, "Stops only what comes from the open side of its line.");
    return changed_;
  }
  const TileShape& shape() const { return shape_; }

 private:
  std::string named(std::string_view part) const { return named_part(name_, part); }

  void draw_slope() {
    drag("left", ImGuiDataType_Double, &shape_.heights[0], &kLowest, &kHighest, "left %.6g px");
    ui_.item(named("left"), "The height of the line at its left end.", "drag, or double click to type");
    ImGui::SameLine();
    drag("right", ImGuiDataType_Double, &shape_.heights[1], &kLowest, &kHighest, "right %.6g px");
    ui_.item(named("right"), "The height of the line at its right end.", "drag, or double click to type");
  }

  // Rows of fields, as many as fit.
  void draw_profile() {
    const float width = ui_.px(kHeightWidth);
    for (std::size_t i = 0; i < shape_.heights.size(); ++i) {
      const std::string part = "height" + std::to_string(i);
      if (i > 0) ui_.same_line_if_fits(width);
      drag(part, ImGuiDataType_Double, &shape_.heights[i], &kLowest, &kHighest, "%.4g", kHeightWidth);
      ui_.item(named(part), "The height of the line there, px.", "drag, or double click to type");
    }
  }

  void draw_width() {
    int tiles = shape_.tiles;
    drag("tiles", ImGuiDataType_S32, &tiles, &kLeastTiles, &kMostTiles,
         tiles == 1 ? "width %d tile" : "width %d tiles");
    ui_.item(named("tiles"), "Over how many tiles it reaches, from the one that has it to the right.",
             "drag, or double click to type");
    if (tiles != shape_.tiles) shape_ = with_width(shape_, tiles);
  }

  void drag(std::string_view part, ImGuiDataType type, void* value, const void* min, const void* max,
            const char* format, float width = 88) {
    ImGui::SetNextItemWidth(ui_.px(width));
    const bool moved = ImGui::DragScalar(("##" + named(part)).c_str(), type, value, 0.125f, min, max, format,
                                         ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemActivated()) stroke_ = session_.next_stroke();
    changed_ = changed_ || moved;
  }

  void check(std::string_view part, std::string_view label, bool& value, std::string_view help) {
    if (ImGui::Checkbox((std::string(label) + "##" + named(part)).c_str(), &value)) note_click();
    ui_.item(named(part), help);
  }

  // What is not dragged is an edit of its own.
  void note_click() {
    changed_ = true;
    stroke_ = 0;
  }

  std::string name_;
  TileShape shape_;
  const Session& session_;
  int& stroke_;
  Ui& ui_;
  bool changed_ = false;
};

}  // namespace

std::string_view kind_label(const TileShape& shape) { return label_of(shape.kind); }

std::optional<Kind> choose_shape_kind(std::string_view name, Kind now, const std::string& shown, Ui& ui) {
  const bool open = ui.begin_combo(name, shown, ui.px(kKindWidth),
                                   "What the ground is where a tile has this: a full tile, a slope between "
                                   "two heights, or a profile with a height for each column line.");
  if (!open) return std::nullopt;
  std::optional<Kind> chosen;
  for (const Kind kind : kChoices) {
    const std::string label(label_of(kind));
    if (ImGui::Selectable(label.c_str(), kind == now) && kind != now) chosen = kind;
    ui.item(named_part(name, label));
  }
  ImGui::EndCombo();
  return chosen;
}

std::optional<TileShape> draw_shape_fields(std::string_view name, const TileShape& shape,
                                           const Session& session, int& stroke, Ui& ui) {
  ShapeFields fields(name, shape, session, stroke, ui);
  if (!fields.draw()) return std::nullopt;
  return fields.shape();
}

}  // namespace talus
