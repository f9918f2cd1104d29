// Two columns: what to start at the left, levels with pictures at the right.
#include "welcome_panel.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "example_list.h"
#include "panels/commands/commands.h"
#include "panels/files/picture_in_list.h"
#include "start_choice.h"

namespace talus {
namespace {

constexpr float kPageWidth = 960, kPageHeight = 620, kPageMargin = 8,
                kPagePadding = 12;  // px at scale 1, of the page
constexpr float kStartWidth = 248, kPageColumnGap = 16;
constexpr float kLeastCard = 180, kCardGap = 8, kNameHeight = 24;
constexpr double kPictureAspect = 16.0 / 9;
constexpr int kNewSides[] = {8, 16, 24, 32};    // px, of a tile
constexpr int kNewColumns = 60, kNewRows = 34;  // cells of the map

// Cards in rows that take the width of the window.
class CardRows {
 public:
  explicit CardRows(Ui& ui) : ui_(ui), gap_(ui.px(kCardGap)) {
    const float room = ImGui::GetContentRegionAvail().x;
    columns_ = std::max(1, static_cast<int>((room + gap_) / (ui.px(kLeastCard) + gap_)));
    width_ = std::floor((room - gap_ * static_cast<float>(columns_ - 1)) / static_cast<float>(columns_));
  }
  int columns() const { return columns_; }

  // A button with a picture, which draw_picture draws if it is seen, over a name. Returns whether it was
  // pressed.
  bool card(const std::string& widget, const std::string& name, const std::string& help,
            const std::function<void(ImVec2 min, ImVec2 max)>& draw_picture) {
    if (count_++ % columns_ != 0) ImGui::SameLine(0, gap_);
    const float picture = std::floor(width_ / static_cast<float>(kPictureAspect)), inset = ui_.px(4);
    const ImVec2 at = ImGui::GetCursorScreenPos(), size{width_, picture + ui_.px(kNameHeight)};
    const bool pressed = button("", widget, size);
    ui_.item(widget, help);
    if (ImGui::IsItemVisible()) {
      draw_picture({at.x + inset, at.y + inset}, {at.x + width_ - inset, at.y + picture});
      const float below = (ui_.px(kNameHeight) - ImGui::GetFontSize()) / 2;
      add_short_text(*ImGui::GetWindowDrawList(), {at.x + inset, at.y + picture + below},
                     at.x + width_ - inset, theme::tone(theme::kText), name);
    }
    return pressed;
  }

 private:
  Ui& ui_;
  float gap_, width_ = 0;
  int columns_ = 1, count_ = 0;
};

// A window that covers the workspace, so that a click beside the page reaches nothing else.
void begin_shade(ImVec2 min, ImVec2 max) {
  ImGui::SetNextWindowPos(min);
  ImGui::SetNextWindowSize({max.x - min.x, max.y - min.y});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::color(theme::kDark, 170));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::Begin("Welcome", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

// In the middle of the shade. ImGui::EndChild() must follow.
void begin_page(ImVec2 size, Ui& ui) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  ui.place("welcome/page", min, {min.x + size.x, min.y + size.y});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::tone(theme::kPanel));
  ImGui::PushStyleColor(ImGuiCol_Border, theme::tone(theme::kLine));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(kPagePadding), ui.px(kPagePadding)));
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);
  ImGui::BeginChild("page", size, true, ImGuiWindowFlags_NavFlattened);
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor(2);
}

void begin_page_column(const char* name, float width) {
  ImGui::BeginChild(name, {width, 0}, false, ImGuiWindowFlags_NavFlattened);
}

// Two choices side by side, each half of the width.
bool draw_choice_pair(const char* widget, const char* first, const char* second, bool is_second,
                      const char* help, Ui& ui) {
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  const std::string name = widget;
  if (ui.text_button(name + "/" + first, first, !is_second, help, {}, true, half)) is_second = false;
  ImGui::SameLine();
  if (ui.text_button(name + "/" + second, second, is_second, help, {}, true, half)) is_second = true;
  return is_second;
}

void draw_page_gap(Ui& ui) { ImGui::Dummy({0, ui.px(8)}); }

}  // namespace

void WelcomePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  bool& open = ui.view.window.welcome_open;
  if (!open) return previews_.clear();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float around = ui.px(kPageMargin), top = ImGui::GetFrameHeight();
  const ImVec2 size{std::min(ui.px(kPageWidth), window.x - 2 * around),
                    std::min(ui.px(kPageHeight), ui.bars_top - top - 2 * around)};
  const ImVec2 min{std::floor((window.x - size.x) / 2), std::floor((top + ui.bars_top - size.y) / 2)};
  begin_shade({0, top}, {window.x, ui.bars_top});
  ImGui::SetCursorScreenPos(min);
  begin_page(size, ui);
  draw_title(session, ui);
  begin_page_column("start", ui.px(kStartWidth));
  draw_start(session, actions, ui);
  ImGui::EndChild();
  ImGui::SameLine(0, ui.px(kPageColumnGap));
  begin_page_column("levels", 0);
  draw_levels(actions, ui);
  ImGui::EndChild();
  ImGui::EndChild();
  if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) open = false;  // beside the page
  ImGui::End();
}

void WelcomePanel::draw_title(const Session& session, Ui& ui) {
  constexpr float kBack = 168;  // px at scale 1
  ui.label("Welcome to Talus");
  ImGui::SameLine(ImGui::GetWindowWidth() - ui.px(kPagePadding + kBack));
  if (ui.text_button("welcome/close", "Back to the level", false,
                     "Closes this page: " + shown_line(session.file_names(), kMaxLabel) + " is behind it.",
                     "Esc", true, ui.px(kBack)))
    ui.view.window.welcome_open = false;
  ImGui::Separator();
}

void WelcomePanel::draw_start(const Session& session, Actions& actions, Ui& ui) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool is_begun = ui.view.tour.step > 0;
  ui.heading("First steps, in three minutes");
  command_text_button("help/tour"_command, session, actions, ui,
                      {.label = is_begun ? "Go on with the tour" : "Take the tour",
                       .widget = "welcome/tour",
                       .width = width});
  draw_page_gap(ui);
  draw_new_level(session, actions, ui);
  draw_page_gap(ui);
  ui.heading("Open");
  command_text_button("file/open"_command, session, actions, ui,
                      {.label = "Open a file...", .widget = "welcome/open", .width = width});
  ui.hint("Or drop files or a folder on the window: levels, maps of Tiled, projects of LDtk, carts.");
  draw_page_gap(ui);
  ui.heading("When Talus starts, show");
  draw_start_choice("welcome/start", width, ui);
}

void WelcomePanel::draw_new_level(const Session& session, Actions& actions, Ui& ui) {
  ui.heading("New level");
  NewContent& content = ui.view.level.new_content;
  const float gap = ImGui::GetStyle().ItemSpacing.x, width = ImGui::GetContentRegionAvail().x;
  const float quarter = (width - 3 * gap) / 4, half = (width - gap) / 2;
  for (const int side : kNewSides) {
    if (side != kNewSides[0]) ImGui::SameLine();
    const std::string text = std::to_string(side);
    if (ui.text_button("welcome/tile" + text, text + "x" + text, side_ == side,
                       "Tiles of " + text + "x" + text + " px.", {}, true, quarter))
      side_ = side;
  }
  const bool was_true_colour = content.in_true_colour || side_ != kCartTileSize;
  const bool in_true_colour = draw_choice_pair(
      "welcome/colours", "Palette", "True colour", was_true_colour,
      "Tiles in 16 colours of a palette, as TIC-80 has them, which then have 8x8 px; or in any colours.", ui);
  if (in_true_colour != was_true_colour) content.in_true_colour = in_true_colour;
  if (!in_true_colour) side_ = kCartTileSize;
  content.plays = draw_choice_pair("welcome/content", "Empty", "Playable", content.plays,
                                   "An empty map, or one with ground, slopes and a player.", ui);
  const bool creates =
      ui.text_button("welcome/new", "New level", false, "Starts a level of 60x34 cells.", {}, true, width);
  ImGui::SetItemDefaultFocus();  // when the page opens
  if (creates) {
    actions.push_back(action::NewLevel{{side_, side_}, kNewColumns, kNewRows, content});
    if (!content.plays) ui.view.sprites.pixels.unfolded = true;  // its tiles wait to be drawn
  }
  command_text_button("file/new_sized"_command, session, actions, ui,
                      {.label = "Other size...", .widget = "welcome/new_sized", .width = half});
  ImGui::SameLine();
  command_text_button("file/new_from_tiles"_command, session, actions, ui,
                      {.label = "From tiles...", .widget = "welcome/new_from_tiles", .width = half});
}

void WelcomePanel::draw_levels(Actions& actions, Ui& ui) {
  const auto& recent = ui.view.files.recent_files;
  ui.heading("Recent levels");
  if (recent.empty()) ui.hint("Levels that you open or save are listed here.");
  CardRows cards(ui);
  const std::size_t shown = std::min(recent.size(), static_cast<std::size_t>(cards.columns()));
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string widget = "welcome/recent" + std::to_string(i);
    const std::string name = std::filesystem::path(recent[i]).filename().string();
    if (cards.card(widget, name, recent[i],
                   [&](ImVec2 min, ImVec2 max) { draw_recent_picture(recent[i], min, max, ui); }))
      actions.push_back(action::OpenFile{recent[i]});
  }
  draw_page_gap(ui);
  draw_examples(actions, ui);
}

void WelcomePanel::draw_examples(Actions& actions, Ui& ui) {
  const bool moves = ui.view.window.is_in_front;
  previews_.begin_frame(ui.time, moves);
  if (moves) ui.want_frames();
  ui.heading("Examples, opened as copies");
  const std::vector<ExampleGroup> groups = example_groups(ui.view.files);
  if (groups.empty()) return;
  group_ = std::min(group_, groups.size() - 1);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (i > 0) ui.same_line_if_fits(size_of_text(groups[i].label).x + ui.px(12));
    if (ui.text_button("welcome/group" + std::to_string(i), groups[i].label, group_ == i, groups[i].help))
      group_ = i;
  }
  CardRows cards(ui);
  const std::vector<std::string>& files = groups[group_].files;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string widget = "welcome/example" + std::to_string(i), name = example_name(files[i]);
    if (cards.card(widget, name, name + ": opens a copy, so that saving asks for a name.",
                   [&](ImVec2 min, ImVec2 max) { previews_.draw(files[i], min, max, ui); }))
      actions.push_back(action::OpenFile{files[i], true});
  }
}

}  // namespace talus
