// Shows the result before and after, with numbers.
#include "picture_import_panel.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "level/level_text.h"
#include "panels/sprites/tile_number.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr float kPreview = 264;    // px at scale 1, largest side of a picture
constexpr float kColorStrip = 10;  // px at scale 1, height of the strips of colours
constexpr float kBetween = 12;     // px at scale 1, between the pictures
constexpr int kReportLines = 4;    // lines that always have room

// The size of a sheet: a whole zoom step, if it fits.
ImVec2 size_of_picture(const SheetLayout& sheet, const Ui& ui) {
  const float width = static_cast<float>(sheet.columns * kCartTileSize);
  const float height = static_cast<float>(sheet.rows() * kCartTileSize);
  const float fits = ui.px(kPreview) / std::max(width, height), zoom = fits < 1 ? fits : std::floor(fits);
  return {width * zoom, height * zoom};
}

SheetId sheet_of(PngPart part) { return part == PngPart::sprites ? SheetId::sprites : SheetId::tiles; }

void draw_palette(const Palette& palette, ImVec2 at, float length, Ui& ui) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = length / kColorCount;
  for (int i = 0; i < kColorCount; ++i) {
    const float x = at.x + static_cast<float>(i) * width;
    list.AddRectFilled({x, at.y}, {x + width, at.y + ui.px(kColorStrip)},
                       theme::color(palette[static_cast<std::size_t>(i)]));
  }
}

// The place of the picture, on a sheet drawn at `at`.
void draw_target(const PngImport& import, const SheetLayout& sheet, ImVec2 at, float cell) {
  if (import.options.part == PngPart::palette) return;
  const Cell tile = sheet.place_of(import.options.tile);
  const int width = import.plan ? import.plan->width : import.picture.width;
  const int height = import.plan ? import.plan->height : import.picture.height;
  const ImVec2 from{at.x + static_cast<float>(tile.x) * cell, at.y + static_cast<float>(tile.y) * cell};
  const float px = cell / kCartTileSize;
  const ImVec2 to{from.x + static_cast<float>(width) * px, from.y + static_cast<float>(height) * px};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(
      at, {at.x + cell * static_cast<float>(sheet.columns), at.y + cell * static_cast<float>(sheet.rows())},
      true);
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kDark), 0, 0, 3);
  list.AddRect(from, to, theme::tone(theme::kAccent));
  list.PopClipRect();
}

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height) + " px";
}

// Says how the plan changes the picture's size; empty if it keeps it.
std::string text_of_fit(const PngImport& import) {
  const PngPicture& picture = import.picture;
  const int width = import.plan->width, height = import.plan->height;
  if (width == picture.width && height == picture.height) return {};
  const bool grows = import.options.fit == PngFit::fill_up;
  return (grows ? "Filled up to " : "Cut off to ") + size_text(width, height) + ". ";
}

std::string text_of_changes(const PngImport& import) {
  const PngImportPlan& plan = *import.plan;
  const bool is_palette = import.options.part == PngPart::palette;
  std::string text = is_palette ? "" : text_of_fit(import);
  if (plan.edit.empty()) return text + "Nothing changes: the level has all of this already.";
  if (!is_palette)
    text += "Changes " + count_text(plan.pixels, "pixel") + " of " + count_text(plan.tiles, "tile") + ".";
  if (is_palette || import.options.take_palette)
    text += (is_palette ? "Changes " : "\nChanges ") + count_text(plan.colors, "colour") +
            ", and so the look of " + count_text(plan.tiles_recolored, "image") + " that are there.";
  return text;
}

// In the line of the text.
void draw_color(Rgb color) {
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, theme::color(color));
  ImGui::GetWindowDrawList()->AddRect(at, {at.x + side, at.y + side}, theme::color(theme::kLine));
  ImGui::Dummy({side, side});
}

// How well the level's colours fit those of the picture.
void draw_match(const PngImportPlan& plan, Ui& ui) {
  if (plan.width == 0) return;
  if (plan.approximated == 0) return ui.hint("Every pixel keeps its own colour.");
  const std::string place = std::to_string(plan.farthest.x) + ", " + std::to_string(plan.farthest.y);
  const std::string text =
      "In the nearest colour instead of their own: " + count_text(plan.approximated, "pixel") +
      ". The one at (" + place + ") changes most:";
  draw_text(text);
  ui.item("import/match");
  draw_color(plan.farthest_from);
  ImGui::SameLine();
  ImGui::TextUnformatted("becomes");
  ImGui::SameLine();
  draw_color(plan.farthest_to);
}

// How the picture's colours and size are adapted to the sheet.
void draw_choices(PngImportOptions& options, bool enabled, Ui& ui) {
  const auto color_choice = [&](bool takes, const char* name, const char* label, const char* help) {
    if (radio_button(label, {}, options.take_palette == takes)) options.take_palette = takes;
    ui.item(name, help, {}, enabled);
  };
  color_choice(false, "import/nearest", "in the level's colours, each pixel in the nearest",
               "The colour with the smallest squared distance in RGB, of equal ones the first.");
  color_choice(true, "import/take_palette", "take over its palette of up to 16 colours",
               "The other images show these colours, too.");
  const auto fit_choice = [&](PngFit fit, const char* name, const char* label, const char* help) {
    ImGui::SameLine();
    if (radio_button(label, {}, options.fit == fit)) options.fit = fit;
    ui.item(name, help, {}, enabled);
  };
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Parts that are not a whole tile, or have no room:");
  fit_choice(PngFit::fill_up, "import/fill_up", "fill up", "With colour 0, to whole tiles of 8x8 px.");
  fit_choice(PngFit::cut_off, "import/cut_off", "cut off",
             "Only the whole tiles of 8x8 px are taken, as many as there is room for.");
}

}  // namespace

void PictureImportPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto imports = [](const Session& now, const View&) { return now.png_import().has_value(); };
  if (!begin_dialog("Import a picture", imports, {0, 0}, session, ui)) return;
  if (const auto& import = session.png_import()) {
    const std::string name = std::filesystem::path(import->path).filename().string();
    ui.heading(name + ", " + std::to_string(import->picture.width) + "x" +
               std::to_string(import->picture.height) + " px");
    PngImportOptions options = draw_options(*import, ui);
    options = draw_pictures(session, *import, options, ui);
    if (options != import->options) actions.push_back(action::SetPngImport{options});
    draw_report(*import, ui);
    draw_buttons(*import, actions, ui);
  }
  ImGui::EndPopup();
}

PngImportOptions PictureImportPanel::draw_options(const PngImport& import, Ui& ui) {
  PngImportOptions options = import.options;
  const auto part = [&](PngPart value, const char* name, const char* label, const char* help) {
    if (ui.text_button(name, label, import.options.part == value, help)) options.part = value;
    ImGui::SameLine();
  };
  ui.begin_row();
  ui.label("Into");
  ImGui::SameLine();
  part(PngPart::tiles, "import/tiles", "Tiles", "It becomes images of the sheet of tiles.");
  part(PngPart::sprites, "import/sprites", "Sprites", "It becomes images of the sheet of sprites.");
  part(PngPart::palette, "import/palette", "Palette",
       "Its pixels, up to 16 side by side, become the level's colours.");
  // For a palette the rows stay, so that the dialog keeps its size under the mouse.
  const bool enabled = options.part != PngPart::palette;
  ImGui::BeginDisabled(!enabled);
  ui.label("from tile");
  ImGui::SameLine();
  const SheetId sheet = sheet_of(options.part);
  int number = number_on_screen(sheet, options.tile);
  const int first = number_on_screen(sheet, 0), last = number_on_screen(sheet, ui.layout(sheet).count - 1);
  ImGui::SetNextItemWidth(ui.px(56));
  if (ImGui::DragInt("##tile", &number, 0.2f, first, last, "%d", ImGuiSliderFlags_AlwaysClamp))
    options.tile = std::clamp(number, first, last) - first;
  ui.item("import/tile", "Where its top left corner goes; a click on the sheet below chooses it, too.", {},
          enabled);
  ui.end_row();
  draw_choices(options, enabled, ui);
  ImGui::EndDisabled();
  return options;
}

PngImportOptions PictureImportPanel::draw_pictures(const Session& session, const PngImport& import,
                                                   PngImportOptions options, Ui& ui) {
  const SheetLayout& sheet = ui.layout(sheet_of(import.options.part));
  const ImVec2 size = size_of_picture(sheet, ui);
  const float cell = size.x / static_cast<float>(sheet.columns), gap = ui.px(kBetween),
              header = ImGui::GetTextLineHeightWithSpacing();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 pictures[2] = {{at.x, at.y + header}, {at.x + size.x + gap, at.y + header}};
  const Palette& before = session.level().palette;
  for (int i = 0; i < 2; ++i) {
    const bool after = i == 1 && import.plan.has_value();
    const ImVec2 from = pictures[i], to{from.x + size.x, from.y + size.y};
    list.AddText({from.x, at.y}, theme::tone(theme::kMuted), i == 0 ? "Before" : "After");
    list.AddImage(after ? ui.preview : ui.sheet(sheet_of(import.options.part)), from, to);
    draw_palette(after ? import.plan->palette : before, {from.x, to.y + ui.px(4)}, size.x, ui);
    draw_target(import, sheet, from, cell);
    ImGui::SetCursorScreenPos(from);
    const char* name = i == 0 ? "import/before" : "import/after";
    const bool pressed = ImGui::InvisibleButton(name, {size.x, size.y + ui.px(4 + kColorStrip)});
    ui.item(name);
    if (!pressed || options.part == PngPart::palette) continue;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    options.tile = sheet.tile_at(sheet.nearest({static_cast<int>(std::floor((mouse.x - from.x) / cell)),
                                                static_cast<int>(std::floor((mouse.y - from.y) / cell))}));
  }
  return options;
}

void PictureImportPanel::draw_report(const PngImport& import, Ui& ui) {
  ImGui::Spacing();
  const float top = ImGui::GetCursorPosY();
  // Not at the window's edge, since the text sets the size of the window.
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() +
                         2 * size_of_picture(ui.layout(sheet_of(import.options.part)), ui).x +
                         ui.px(kBetween));
  if (import.plan) {
    draw_text(text_of_changes(import));
    ui.item("import/report");
    draw_match(*import.plan, ui);
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kError));
    draw_text(import.plan.error());
    ImGui::PopStyleColor();
    ui.item("import/error");
  }
  ImGui::PopTextWrapPos();
  const float bottom = top + kReportLines * ImGui::GetTextLineHeightWithSpacing();
  ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), bottom));
}

void PictureImportPanel::draw_buttons(const PngImport& import, Actions& actions, Ui& ui) {
  const bool changes = import.plan && !import.plan->edit.empty();
  const float width = ui.px(112);
  const DialogButton apply{.widget = "import/apply",
                           .label = "Apply",
                           .help = "Takes it into the level; undoable.",
                           .letter = 'A',
                           .is_default = true,
                           .enabled = changes,
                           .width = width,
                           .gets_the_keys = true};
  if (dialog_button(apply, ui)) actions.push_back(action::ApplyPngImport{});
  ImGui::SameLine();
  const DialogButton cancel{.widget = "import/cancel",
                            .label = "Cancel",
                            .help = "Goes back to the level.",
                            .letter = 'C',
                            .is_cancel = true,
                            .width = width,
                            .gets_the_keys = !changes};
  if (dialog_button(cancel, ui)) actions.push_back(action::CancelPngImport{});
  ImGui::SameLine();
  const DialogButton as_tiles{.widget = "import/as_tiles",
                              .label = "New level...",
                              .help = "Cuts the picture into tiles, and starts an empty level with them.",
                              .letter = 'N',
                              .width = width};
  if (dialog_button(as_tiles, ui)) {
    actions.push_back(action::CancelPngImport{});
    actions.push_back(action::OpenTiles{import.path});
  }
}

}  // namespace talus
