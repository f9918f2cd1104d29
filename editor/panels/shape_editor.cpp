// Kind, heights, width and sides of a shape.
#include "shape_editor.h"

#include <array>
#include <string>

namespace talus {
namespace {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

constexpr std::array<Kind, 3> kChoices = {Kind::none, Kind::solid, Kind::slope};
constexpr double kLowest = 0, kHighest = kMaxShapeTiles * kTileSide;
constexpr int kLeastTiles = 1, kMostTiles = kMaxShapeTiles;

std::string_view label_of(Kind kind) {
  constexpr std::array<std::string_view, 4> kLabels = {"none", "solid", "slope", "profile"};
  return kLabels[static_cast<std::size_t>(kind)];
}

// A shape of this kind that can be used, as like the old one as may be.
TileShape with_kind(TileShape shape, Kind kind) {
  if (kind == Kind::none) return {};
  shape.kind = kind;
  shape.heights = kind == Kind::slope ? std::vector<double>{0, kTileSide} : std::vector<double>();
  if (kind == Kind::solid) {
    shape.tiles = 1;
    shape.side = Side::floor;
  }
  return shape;
}

class ShapeEditor {
 public:
  ShapeEditor(std::string_view name, const TileShape& shape, const Session& session, int& stroke, Ui& ui)
      : name_(name), shape_(shape), session_(session), stroke_(stroke), ui_(ui) {}

  bool draw() {
    draw_kind();
    if (shape_.kind == Kind::none) return changed_;
    if (shape_.kind == Kind::slope) draw_slope();
    if (shape_.kind != Kind::solid) {
      bool hangs = shape_.side == Side::ceiling;
      check("ceiling", "hangs from the ceiling", hangs, "The ground is above the line, measured downwards.");
      shape_.side = hangs ? Side::ceiling : Side::floor;
    }
    check("one_way", "one-way", shape_.one_way, "Stops only what comes from the open side of its line.");
    return changed_;
  }
  const TileShape& shape() const { return shape_; }

 private:
  std::string named(std::string_view part) const { return name_ + "_" + std::string(part); }

  void draw_kind() {
    const bool open = ui_.begin_combo(name_, std::string(kind_label(shape_)), ui_.px(180),
                                      "What the ground is where a tile has this; a profile of many heights "
                                      "is made in the file.");
    if (!open) return;
    const Kind now = shape_.kind;
    for (const Kind kind : kChoices) {
      const std::string label(label_of(kind));
      if (ImGui::Selectable(label.c_str(), kind == now) && kind != now) {
        shape_ = with_kind(shape_, kind);
        note_click();
      }
      ui_.item(named(label));
    }
    ImGui::EndCombo();
  }

  void draw_slope() {
    drag("left", ImGuiDataType_Double, &shape_.heights[0], &kLowest, &kHighest, "left %.6g px");
    ui_.item(named("left"), "The height of the line at its left end.", "drag, or double click to type");
    ImGui::SameLine();
    drag("right", ImGuiDataType_Double, &shape_.heights[1], &kLowest, &kHighest, "right %.6g px");
    ui_.item(named("right"), "The height of the line at its right end.", "drag, or double click to type");
    drag("tiles", ImGuiDataType_S32, &shape_.tiles, &kLeastTiles, &kMostTiles, "width %d tiles");
    ui_.item(named("tiles"), "Over how many tiles it reaches, from the one that has it to the right.",
             "drag, or double click to type");
  }

  void drag(std::string_view part, ImGuiDataType type, void* value, const void* min, const void* max,
            const char* format) {
    ImGui::SetNextItemWidth(ui_.px(88));
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

std::optional<TileShape> draw_shape(std::string_view name, const TileShape& shape, const Session& session,
                                    int& stroke, Ui& ui) {
  ShapeEditor editor(name, shape, session, stroke, ui);
  if (!editor.draw()) return std::nullopt;
  return editor.shape();
}

}  // namespace talus
