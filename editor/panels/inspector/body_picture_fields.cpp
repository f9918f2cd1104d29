// Takes frames from the sheets.
#include "body_picture_fields.h"

#include <cmath>
#include <string>
#include <utility>

#include "chosen_spawn.h"
#include "edit/body_frames.h"
#include "level/single_change.h"

namespace talus {
namespace {

constexpr float kFrameSide = 28;  // px at scale 1

struct ActText {
  std::string_view label, help;
};
constexpr std::array<ActText, kBodyActs> kActs = {
    {{"Stand", "while it stands, and for what has no frames of its own"},
     {"Run", "while it runs or rolls"},
     {"Jump", "while it rises"},
     {"Fall", "while it falls"}}};

void change_picture(const Session& session, int index, const BodyPicture& picture, int stroke,
                    Actions& actions) {
  Spawn spawn = spawn_of(session, index);
  spawn.picture = picture;
  actions.push_back(action::EditLevel{
      change_spawn(session.level(), index, std::move(spawn), "Change a body's picture"), stroke});
}

// The frames of an act that are on the sheet, from the left, as many as fit.
void draw_frames(const BodyPicture& picture, BodyAct act, const Level& level, Ui& ui) {
  const SheetLayout layout = level.sheet(picture.sheet).layout();
  const TileSize tile = level.map.tile_size();
  const float aspect =
      static_cast<float>(picture.columns * tile.width) / static_cast<float>(picture.rows * tile.height);
  const ImVec2 size{ui.px(kFrameSide) * std::min(1.0f, aspect),
                    ui.px(kFrameSide) * std::min(1.0f, 1 / aspect)};
  const BodyFrames frames = on_sheet(picture, layout)[act];
  for (int i = 0; i < frames.count; ++i) {
    ImGui::SameLine(0, ui.px(2));
    if (ImGui::GetContentRegionAvail().x < size.x) return ImGui::NewLine();
    const Cell at = layout.place_of(frames.first + i * picture.columns);
    const UvRect uv = ui.uv_of(picture.sheet, {at.x, at.y, picture.columns, picture.rows});
    ImGui::Image(ui.clear_sheet(picture.sheet), size, uv.from, uv.to);
  }
}

// The heading, which folds what is below it. is_wanted: else it is folded at first. Returns whether that is
// shown.
bool draw_folding_heading(bool is_wanted, Ui& ui) {
  const auto& fonts = ImGui::GetIO().Fonts->Fonts;
  const bool has_bold = fonts.Size > kBoldFont;
  if (has_bold) ImGui::PushFont(fonts[kBoldFont]);
  ImGui::PushID(is_wanted ? 1 : 0);  // each has a state of its own
  const bool is_open = ImGui::TreeNodeEx(
      "Picture", ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth |
                     (is_wanted ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None));
  ImGui::PopID();
  if (has_bold) ImGui::PopFont();
  ui.item("inspector/picture");
  return is_open;
}

}  // namespace

void BodyPictureFields::draw(const Session& session, int index, Actions& actions, Ui& ui) {
  const Spawn spawn = spawn_of(session, index);
  const bool is_wanted = traits_of(spawn.kind).takes_keys || !spawn.picture.empty();
  if (!draw_folding_heading(is_wanted, ui)) return;
  ui.begin_row();
  for (int act = 0; act < kBodyActs; ++act) draw_act(static_cast<BodyAct>(act), session, index, actions, ui);
  if (!spawn.picture.empty()) draw_frame(session, index, actions, ui);
  ui.end_row();
}

void BodyPictureFields::draw_act(BodyAct act, const Session& session, int index, Actions& actions, Ui& ui) {
  const auto& [label, help] = kActs[static_cast<std::size_t>(act)];
  const std::string word(kBodyActWords[static_cast<std::size_t>(act)]);
  const BodyPicture& picture = spawn_of(session, index).picture;
  ui.field_label(label);
  const SpriteArea& area = session.choices().area;
  const std::string images = area.sheet == SheetId::tiles ? "tiles" : "sprites";
  if (ui.text_button("inspector/picture_" + word, "Take " + images, false,
                     "Shows the chosen " + images + " of the sheet " + std::string(help) +
                         ": frames side by side, as high as these " + images + ".")) {
    const auto taken = with_frames(session.level(), spawn_of(session, index), act, area);
    if (shows_nothing(session.level(), area))
      actions.push_back(action::ShowMessage{
          "The chosen " + images + " are blank: choose those of the body on the sheet first.", true});
    else if (taken)
      change_picture(session, index, *taken, 0, actions);
    else
      actions.push_back(action::ShowMessage{taken.error(), true});
  }
  if (picture[act].count > 0) {
    ImGui::SameLine();
    if (ui.icon_button("inspector/no_picture_" + word, Icon::close, false, "Takes these frames away.", "")) {
      BodyPicture without = picture;
      without[act] = {};
      change_picture(session, index, without.empty() ? BodyPicture() : without, 0, actions);
    }
    draw_frames(picture, act, session.level(), ui);
  }
}

void BodyPictureFields::draw_frame(const Session& session, int index, Actions& actions, Ui& ui) {
  BodyPicture picture = spawn_of(session, index).picture;
  double columns = picture.columns, steps = picture.steps;
  ui.field_label("Frames");
  const bool has_columns = draw_number_field(
      {"inspector/picture_columns", "%.0f wide",
       "How many tiles a frame is wide. The tiles of each act are cut anew.", kFormField, 0.1f},
      columns, session, number_, ui);
  ImGui::SameLine();
  const bool has_steps = draw_number_field(
      {"inspector/picture_steps", "%.0f steps",
       "How long a frame is shown, in steps of the physics: 60 are a second.", kFormField, 0.2f},
      steps, session, number_, ui);
  const auto whole = [](double value, int most) {
    return static_cast<int>(std::clamp(std::round(value), 1.0, static_cast<double>(most)));
  };
  if (has_columns) picture = with_columns(picture, whole(columns, kMaxBodyPictureSide));
  if (has_steps) picture.steps = static_cast<std::uint16_t>(whole(steps, kMaxFrameSteps));
  if (picture != spawn_of(session, index).picture)
    change_picture(session, index, picture, number_.stroke, actions);
}

}  // namespace talus
