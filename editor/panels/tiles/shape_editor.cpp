// Kind, heights, width and sides of a shape.
#include "shape_editor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "edit/tile_shapes.h"

namespace talus {
namespace {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

constexpr std::array<Kind, 5> kChoices = {Kind::none, Kind::solid, Kind::slope, Kind::profile, Kind::polygon};
constexpr float kKindWidth = 132;      // px at scale 1, of the list of kinds
constexpr float kCheckWidth = 88;      // px at scale 1, of a check box
constexpr float kConveyorWidth = 104;  // px at scale 1, of the speed of a conveyor
constexpr float kHeightWidth = 32;     // px at scale 1, least width of one height

std::string named_part(std::string_view name, std::string_view part) {
  return std::string(name) + "_" + std::string(part);
}

class ShapeFields {
 public:
  ShapeFields(std::string_view name, const TileShape& shape, const Session& session, NumberEdit& edit,
              Actions& actions, Ui& ui)
      : name_(name), shape_(shape), session_(session), edit_(edit), actions_(actions), ui_(ui) {}

  bool draw() {
    if (shape_.kind == Kind::none) return false;
    if (shape_.kind == Kind::group)
      draw_conveyor();
    else
      draw_form();
    return changed_;
  }
  const TileShape& shape() const { return shape_; }

 private:
  void draw_form() {
    if (shape_.kind == Kind::polygon) {
      draw_one_way();
      if (shape_.one_way) {
        ui_.same_line_if_fits(ui_.px(kCheckWidth));
        draw_ceiling("Its lower lines stop bodies, and not its upper ones.");
      }
      return draw_conveyor_beside();
    }
    if (shape_.kind == Kind::slope) draw_slope();
    if (shape_.kind == Kind::profile) draw_profile();
    if (has_heights(shape_)) {
      draw_conveyor_beside();
      draw_width();
      ui_.same_line_if_fits(ui_.px(kCheckWidth));
      draw_ceiling("The ground hangs above the line, and is measured downwards.");
      ui_.same_line_if_fits(ui_.px(kCheckWidth));
    }
    draw_one_way();
    if (!has_heights(shape_)) draw_conveyor_beside();
  }

  std::string named(std::string_view part) const { return named_part(name_, part); }

  void draw_ceiling(std::string_view help) {
    bool hangs = shape_.side == Side::ceiling;
    check("ceiling", "ceiling", hangs, help);
    shape_.side = hangs ? Side::ceiling : Side::floor;
  }

  void draw_one_way() {
    check("one_way", "one-way", shape_.one_way, "Stops only what comes from the open side of its line.");
  }

  void draw_conveyor_beside() {
    ui_.same_line_if_fits(ui_.px(kConveyorWidth));
    draw_conveyor();
  }

  void draw_conveyor() {
    const std::string name = named("conveyor");
    double speed = shape_.conveyor;
    const NumberField field{
        name, "conveyor %.4g",
        "How fast its surface goes, px a frame: on a floor to the right, and clockwise around the "
        "ground. It carries players, and what rubs on it where bodies meet.",
        kConveyorWidth, 1.0f / 64};
    if (!draw_number_field(field, speed, session_, edit_, ui_)) return;
    shape_.conveyor = std::clamp(speed, -kMaxConveyor, kMaxConveyor);
    changed_ = true;
  }

  void draw_slope() {
    const float width = width_of("right %.6g px");
    height(0, "left", "left %.6g px", "The height of the line at its left end.", width);
    ImGui::SameLine();
    height(1, "right", "right %.6g px", "The height of the line at its right end.", width);
  }

  // Rows of fields, with as many as fit.
  void draw_profile() {
    const float width = width_of("%.4g");
    for (std::size_t i = 0; i < shape_.heights.size(); ++i) {
      if (i > 0) ui_.same_line_if_fits(ui_.px(width));
      height(i, "height" + std::to_string(i), "%.4g", "The height of the line there, px.", width);
    }
  }

  void draw_width() {
    const char* format = shape_.tiles == 1 ? "width %.0f tile" : "width %.0f tiles";
    const auto tiles = number("tiles", format, shape_.tiles, 1, kMaxShapeTiles,
                              "The number of tiles that it covers, from its own tile to the right.", 88);
    if (!tiles) return;
    if (*tiles != std::round(*tiles)) return refuse("a width must be whole tiles");
    if (*tiles != shape_.tiles) shape_ = with_width(shape_, static_cast<int>(*tiles), tile_size());
    changed_ = true;
  }

  // Room for each height, px at scale 1.
  float width_of(const char* format) const {
    float widest = 0;
    std::array<char, 40> text{};
    for (const double height : shape_.heights) {
      std::snprintf(text.data(), text.size(), format, height);
      widest = std::max(widest, ImGui::CalcTextSize(text.data()).x);
    }
    return std::max(kHeightWidth, widest / ui_.scale + 12);
  }

  void height(std::size_t i, std::string_view part, const char* format, std::string_view help, float width) {
    const auto height =
        number(part, format, shape_.heights[i], 0, kMaxShapeTiles * tile_size().height, help, width);
    if (!height) return;
    shape_.heights[i] = *height;
    changed_ = true;
  }

  // The number after the last change.
  std::optional<double> number(std::string_view part, const char* format, double value, int least, int most,
                               std::string_view help, float width) {
    const std::string name = named(part);
    if (!draw_number_field({name, format, help, width, 0.125f}, value, session_, edit_, ui_))
      return std::nullopt;
    const double kept = std::clamp<double>(value, least, most);
    if (kept == value || ImGui::IsItemActive()) return kept;  // active: a drag, which stops at its limits
    const std::string what = part == "tiles" ? "a width must be " : "a height must be ";
    refuse(what + std::to_string(least) + " to " + std::to_string(most) +
           (part == "tiles" ? " tiles" : " px"));
    return std::nullopt;
  }

  TileSize tile_size() const { return session_.level().map.tile_size(); }

  void refuse(const std::string& why) {
    actions_.push_back(action::ShowMessage{"Not changed: " + why + ".", true});
  }

  void check(std::string_view part, std::string_view label, bool& value, std::string_view help) {
    if (checkbox(std::string(label), named(part), value)) note_click();
    ui_.item(named(part), help);
  }

  // A change without a drag is an edit of its own.
  void note_click() {
    changed_ = true;
    edit_.stroke = 0;
  }

  std::string name_;
  TileShape shape_;
  const Session& session_;
  NumberEdit& edit_;
  Actions& actions_;
  Ui& ui_;
  bool changed_ = false;
};

}  // namespace

std::string_view kind_label(Kind kind) {
  constexpr std::array<std::string_view, 6> kLabels = {"none",    "solid",   "slope",
                                                       "profile", "polygon", "group"};
  return kLabels[static_cast<std::size_t>(kind)];
}
std::string_view kind_label(const TileShape& shape) { return kind_label(shape.kind); }

std::optional<Kind> choose_shape_kind(std::string_view name, Kind now, const std::string& shown, Ui& ui) {
  const bool open = ui.begin_combo(name, shown, ui.px(kKindWidth),
                                   "The ground of such a tile: a full tile, a slope between "
                                   "two heights, a profile with a height for each column line, or a "
                                   "polygon, which begins as the outline of the old shape.");
  if (!open) return std::nullopt;
  std::optional<Kind> chosen;
  for (const Kind kind : kChoices) {
    const std::string label(kind_label(kind));
    if (selectable(label, {}, kind == now) && kind != now) chosen = kind;
    ui.item(named_part(name, label));
  }
  ImGui::EndCombo();
  return chosen;
}

std::optional<TileShape> draw_shape_fields(std::string_view name, const TileShape& shape,
                                           const Session& session, NumberEdit& edit, Actions& actions,
                                           Ui& ui) {
  ShapeFields fields(name, shape, session, edit, actions, ui);
  if (!fields.draw()) return std::nullopt;
  return fields.shape();
}

}  // namespace talus
