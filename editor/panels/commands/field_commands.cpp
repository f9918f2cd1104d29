// The commands that go to a field or a list of a panel, where a value is typed or chosen.
#include "command_table.h"
#include "edit/brushes.h"
#include "panels/inspector/chosen_curve.h"
#include "panels/inspector/chosen_spawn.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;
using FieldEnabled = decltype(Command::enabled);

// Of a panel beside the map.
template <const std::string_view& panel, const std::string_view& field>
void go_to_field(S, A, U ui) {
  ui.view.wants_tab = panel;
  ui.view.wants_text = field;
}

template <const std::string_view& panel, const std::string_view& field>
Command field_command(std::string_view id, std::string_view label, std::string_view help,
                      std::string_view words, FieldEnabled enabled = nullptr) {
  return also_called(words, command(id, {}, label, help, go_to_field<panel, field>, enabled));
}

// Ids of panels, and widgets in them.
constexpr std::string_view kColorTab = "color", kColorHex = "palette/hex", kColorRed = "palette/red_number",
                           kColorGreen = "palette/green_number", kColorBlue = "palette/blue_number";

std::vector<Command> color_fields() {
  return {
      field_command<kColorTab, kColorHex>(
          "palette/type", "Type the colour...",
          "Goes to the field of the chosen colour, as RRGGBB or RGB; Enter sets it.",
          "hex rgb edit color palette"),
      field_command<kColorTab, kColorRed>(
          "palette/type_red", "Type the colour's red...",
          "Goes to the number of red, 0 to 255; Tab goes on to green and blue.",
          "edit color rgb slider palette"),
      field_command<kColorTab, kColorGreen>("palette/type_green", "Type the colour's green...",
                                            "Goes to the number of green, 0 to 255.",
                                            "edit color rgb slider palette"),
      field_command<kColorTab, kColorBlue>("palette/type_blue", "Type the colour's blue...",
                                           "Goes to the number of blue, 0 to 255.",
                                           "edit color rgb slider palette"),
  };
}

constexpr std::string_view kInspectorTab = "inspector", kBodyName = "inspector/spawn_name",
                           kBodyKind = "inspector/kind", kBodyFoot = "inspector/foot",
                           kBodyX = "inspector/start_x", kBodyVelocity = "inspector/start_vx";
constexpr std::string_view kBodyWords = "spawn object entity player ball start inspector";

// The inspector shows curves while a tool draws them.
bool shows_spawn(S session, const Ui&) {
  return !draws_curves(session.choices().map_tool) && chosen_spawn(session) >= 0;
}

template <int step>
void choose_body(S session, A actions, U ui) {
  const auto& bodies = session.state().bodies;
  std::size_t next = step > 0 ? 0 : bodies.size() - 1;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].id == session.choices().body)
      next = (i + bodies.size() + static_cast<std::size_t>(step)) % bodies.size();
  actions.push_back(action::SelectBody{bodies[next].id});
  if (draws_curves(session.choices().map_tool)) actions.push_back(action::SetMapTool{MapTool::body});
  ui.view.wants_tab = kInspectorTab;
}
bool has_body_to_choose(S session, const Ui&) { return !session.state().bodies.empty(); }

std::vector<Command> body_fields() {
  return {
      also_called(kBodyWords,
                  repeating(command("bodies/next", {}, "Choose the next body", "Shows it in the inspector.",
                                    choose_body<1>, has_body_to_choose))),
      also_called(kBodyWords,
                  repeating(command("bodies/previous", {}, "Choose the body before",
                                    "Shows it in the inspector.", choose_body<-1>, has_body_to_choose))),
      field_command<kInspectorTab, kBodyName>("bodies/name", "Name the body...",
                                              "Goes to the field of the chosen placed body's name.",
                                              "spawn object entity rename inspector", shows_spawn),
      field_command<kInspectorTab, kBodyKind>("bodies/kind", "Make the body a ball or a player...",
                                              "Opens the list of what the chosen placed body is.",
                                              "spawn object entity type inspector", shows_spawn),
      field_command<kInspectorTab, kBodyFoot>("bodies/foot", "What of the body stands on slopes...",
                                              "Opens the list: its box, or its centre.",
                                              "spawn foot centre box inspector", shows_spawn),
      field_command<kInspectorTab, kBodyX>("bodies/position", "Type where the body starts...",
                                           "Goes to the chosen placed body's x; Tab goes on to its y.",
                                           "spawn object position x y coordinates", shows_spawn),
      field_command<kInspectorTab, kBodyVelocity>(
          "bodies/velocity", "Type the body's velocity at the start...",
          "Goes to the chosen placed body's vx; Tab goes on to its vy.", "spawn object speed initial vx vy",
          shows_spawn),
  };
}

constexpr std::string_view kCurveName = "inspector/curve_name", kCurveFaces = "inspector/curve_faces";
constexpr std::string_view kCurveWords = "line segment arc polyline inspector";

bool has_curve_to_choose(S session, const Ui&) { return !session.level().curves.empty(); }
bool shows_curve(S session, const Ui&) {
  return draws_curves(session.choices().map_tool) && chosen_curve(session) >= 0;
}

void choose_next_curve(S session, A actions, U ui) {
  const int count = static_cast<int>(session.level().curves.size());
  const int next = (chosen_curve(session) + 1) % count;
  if (!draws_curves(session.choices().map_tool)) actions.push_back(action::SetMapTool{MapTool::curve});
  actions.push_back(action::SelectCurve{next});
  ui.view.wants_tab = kInspectorTab;
}

std::vector<Command> curve_fields() {
  return {
      also_called(kCurveWords, repeating(command("curves/next", {}, "Choose the next curve",
                                                 "Shows it in the inspector, with the curve tool.",
                                                 choose_next_curve, has_curve_to_choose))),
      field_command<kInspectorTab, kCurveName>("curves/name", "Name the curve...",
                                               "Goes to the field of the chosen curve's name.",
                                               "rename line segment inspector", shows_curve),
      field_command<kInspectorTab, kCurveFaces>("curves/faces", "Which way the curve faces...",
                                                "Opens the list: up, down or both ways.",
                                                "line segment one-way floor ceiling", shows_curve),
  };
}

constexpr std::string_view kShapeTab = "shape", kShapeKind = "shape/kind", kShapeTurn = "shape/turn",
                           kProblemsTab = "problems", kProblemKind = "problems/kind",
                           kProblemSeam = "problems/seam", kBrushesTab = "brushes";

bool has_tile_to_shape(S session, const Ui&) { return session.choices().area.sheet == SheetId::tiles; }
bool has_shape_to_copy(S session, const Ui& ui) {
  const auto tile = static_cast<std::uint8_t>(session.choices().area.tile_at(0, 0));
  return has_tile_to_shape(session, ui) && shape_of_tile(session.level(), tile).kind != TileShape::Kind::none;
}

// The brush that is the stamp now, or else the last one.
int brush_to_name(S session) {
  const auto& brushes = session.level().brushes;
  for (std::size_t i = 0; i < brushes.size(); ++i)
    if (stamp_of_brush(brushes[i]) == session.choices().stamp) return static_cast<int>(i);
  return static_cast<int>(brushes.size()) - 1;
}
bool has_brush_to_take(S session, const Ui&) { return !session.level().brushes.empty(); }

void name_brush(S session, A, U ui) {
  ui.view.wants_tab = kBrushesTab;
  ui.view.wants_text = "brushes/" + std::to_string(brush_to_name(session)) + "/name";
}

void take_next_brush(S session, A actions, U) {
  const auto& brushes = session.level().brushes;
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < brushes.size(); ++i)
    if (stamp_of_brush(brushes[i]) == session.choices().stamp) next = i + 1;
  actions.push_back(action::SetStamp{stamp_of_brush(brushes[next])});
  actions.push_back(action::SetRandomStamp{brushes[next].random, session.choices().random_seed});
  actions.push_back(action::SetMapTool{MapTool::stamp});
}

// The field is there while such problems are listed.
void type_seam(S session, A actions, U ui) {
  ui.view.problems.kind = "seam";
  go_to_field<kProblemsTab, kProblemSeam>(session, actions, ui);
}

std::vector<Command> other_fields() {
  return {
      field_command<kShapeTab, kShapeKind>("shape/choose", "Choose the tile's shape...",
                                           "Opens the list: none, solid, slope or profile.",
                                           "collision ground kind full slope heights", has_tile_to_shape),
      field_command<kShapeTab, kShapeTurn>(
          "shape/turn_copy", "Copy the tile turned or mirrored...",
          "Opens the list of turns; Tab goes on to the tile that gets the copy.",
          "mirror flip rotate shape duplicate", has_shape_to_copy),
      field_command<kProblemsTab, kProblemKind>("problems/choose", "List problems of one kind...",
                                                "Opens the list of what is looked for.",
                                                "lint filter rule check"),
      also_called("lint seam tolerance step",
                  command("problems/type_seam", {}, "Type how far floors may jump...",
                          "Goes to the px that a floor may jump without being listed.", type_seam)),
      also_called("stamp pattern", repeating(command("brushes/next", {}, "Take the next brush",
                                                     "Makes the next of the level's brushes the stamp.",
                                                     take_next_brush, has_brush_to_take))),
      also_called("stamp pattern rename",
                  command("brushes/type_name", {}, "Name the brush...",
                          "Goes to the name of the brush that is the stamp, or else of the last one.",
                          name_brush, has_brush_to_take)),
      also_called("parting threshold difference",
                  command("compare/type_parting", {}, "Type how far apart counts as parted...",
                          "Goes to the px by which bodies are apart when the sides have parted.",
                          [](S, A, U ui) {
                            ui.view.dock_open = true;
                            ui.view.wants_tab = "compare";
                            ui.view.wants_text = "compare/threshold";
                          })),
      also_called("solver branch difference", command("compare/choose", {}, "Compare with...",
                                                      "Opens the list of what there is to compare with.",
                                                      [](S, A, U ui) {
                                                        ui.view.dock_open = true;
                                                        ui.view.wants_tab = "compare";
                                                        ui.view.wants_text = "compare/with";
                                                      })),
  };
}

}  // namespace

std::vector<Command> field_commands() {
  return joined({color_fields(), body_fields(), curve_fields(), other_fields()});
}

}  // namespace talus
