// Ui: what panels draw with: textures, scale, view, the registry of widgets, and shared controls.
#pragma once

#include <imgui.h>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "icons.h"
#include "level/cell_rect.h"
#include "level/lint/lint.h"
#include "map_textures.h"
#include "panels/view.h"
#include "picture_textures.h"
#include "shown_text.h"
#include "small_pictures.h"
#include "theme.h"
#include "widget_registry.h"

namespace talus {

class Session;

// Whether a dialog should be open.
using DialogTest = std::function<bool(const Session&, const View&)>;

// The corners of a part of a texture, 0..1.
struct UvRect {
  ImVec2 from, to;
};

// Of ImGui's fonts, the bold one; it is missing where no font file is installed.
inline constexpr int kBoldFont = 1;

// px at scale 1: of the left column of a form, and of a field of which two fit beside it.
inline constexpr float kFormLabel = 64, kFormField = 80;

class Ui {
 public:
  View view;
  WidgetRegistry widgets;
  std::array<ImTextureID, 2> sheets{};          // by SheetId; 8x8 px for each image
  std::array<SheetLayout, 2> layouts{};         // by SheetId, of the images
  MapTextures* map_textures = nullptr;          // null: the map is drawn tile by tile at any zoom
  PictureTextures* picture_textures = nullptr;  // null: pictures besides the sheet's are not drawn
  SmallPictures* small_pictures = nullptr;      // never null in a frame
  ImTextureID preview{};                        // the sheet as an import would change it, while that is shown
  std::array<ImTextureID, 2> clear_sheets{};    // with colour 0 clear, for bodies and layers; by SheetId
  // The problems of the level; never null in a frame. Not updated while a button is held, so that a stroke on
  // a huge map need not wait for the lint in each frame.
  const std::vector<Problem>* problems = nullptr;
  float scale = 1;  // of text and controls
  double time = 0;  // s, of this frame
  // y of the bars at the bottom of the window, px of the screen: tooltips stay above them, so that the bars
  // can be read.
  float bars_top = 0;
  ImVec2 side_min, side_max;  // the right column, or else the left one, px of the screen, for messages
  float messages_height = 0;  // px of the screen, that they take at its bottom

  ImTextureID sheet(SheetId id) const { return sheets[static_cast<std::size_t>(id)]; }
  ImTextureID clear_sheet(SheetId id) const { return clear_sheets[static_cast<std::size_t>(id)]; }
  const SheetLayout& layout(SheetId id) const { return layouts[static_cast<std::size_t>(id)]; }
  // The place of a tile on the sheet.
  CellRect place_on_sheet(int tile) const;
  // The part of a sheet's texture that shows some images. tiles: columns and rows of the sheet.
  UvRect uv_of(SheetId id, CellRect tiles) const;
  // The same for a tile by its number.
  UvRect uv_of(int tile) const;
  // Converts px at scale 1 to px of the screen.
  float px(float length) const { return static_cast<float>(static_cast<int>(length * scale + 0.5f)); }

  // Asks another panel for something; see Requests.
  template <class R>
  void ask(R request) {
    view.requests.ask(std::move(request));
  }

  // Called by begin_dialog(): `wanted` is kept until the next frame begins.
  void add_dialog(std::string_view title, DialogTest wanted) {
    dialogs_.emplace_back(title, std::move(wanted));
  }
  // Whether a dialog of this title, which was begun in this frame or the one before, should be open now.
  bool wants_dialog(std::string_view title, const Session& session) const;
  // The titles of the dialogs that should be open now, of those that were begun in this frame.
  std::vector<std::string> wanted_dialogs(const Session& session) const;

  // The next enabled control with a name gets the focus and shows it.
  void focus_next_item(bool on = true) { focuses_next_ = on; }

  // Registers ImGui's last item under this name. When the mouse rests on it, shows the help and the key.
  void item(std::string_view name, std::string_view help = {}, std::string_view key = {},
            bool enabled = true);
  // The same for a place that is not an item of ImGui.
  void place(std::string_view name, ImVec2 min, ImVec2 max, bool enabled = true);
  // Help for ImGui's last item, which has no name of its own.
  void tooltip(std::string_view help, std::string_view key = {});
  // Something moves although nothing happens: the next frame is drawn without waiting.
  void want_frames() { moves_ = true; }
  // Whether it does, or a tooltip is due soon.
  bool wants_frames() const { return tooltip_pending_ || moves_; }

  // A square button with an icon; `lit` shows it as switched on.
  bool icon_button(std::string_view name, Icon icon, bool lit, std::string_view help, std::string_view key,
                   bool enabled = true);
  // A button with text; width 0 fits the text, height 0 is that of all buttons.
  bool text_button(std::string_view name, std::string_view label, bool lit, std::string_view help,
                   std::string_view key = {}, bool enabled = true, float width = 0, float height = 0);
  // A choice as high as a button. ImGui::EndCombo() must follow if it returns true.
  bool begin_combo(std::string_view name, const std::string& shown, float width, std::string_view help,
                   std::string_view key = {});
  // Between these calls fields are as high as buttons, and plain text is in line with both.
  void begin_row();
  void end_row();
  // Text in a row of buttons.
  void label(std::string_view text);
  // What the fields of a row are, in a column of its own: the left one of a form. The fields follow beside
  // it.
  void field_label(std::string_view text);
  // The title of what follows below it, bold if the window has such a font.
  void heading(std::string_view text);
  // What a value or a control beside it is, in the muted colour.
  void muted(std::string_view text);
  // The text for an empty state: a wrapped sentence that says what to do next.
  void hint(std::string_view text);
  // A number that ends at the right edge of the current column.
  void right_aligned(std::string_view text, ImU32 color = theme::tone(theme::kText));
  // Keeps the next item of this width on the line if it fits there, `gap` px further than usual.
  void same_line_if_fits(float width, float gap = 0);

 private:
  void take_focus(std::string_view name, bool enabled);  // for ImGui's last item, if it should get the focus
  void show_tooltip_when_rested(ImGuiID id, std::string_view help, std::string_view key);
  void place_tooltip() const;
  ImGuiID rested_on_ = 0;    // what the mouse was on at the end of the last frame, if it has help
  double rested_since_ = 0;  // s
  ImGuiID rests_on_ = 0;     // the same in this frame; of overlapping items the one that was drawn last
  ImGuiID pressed_on_ = 0;   // what was pressed while the mouse was on it, which has not gone elsewhere since
  std::vector<std::pair<std::string, DialogTest>> dialogs_;         // title and test
  std::vector<std::pair<std::string, DialogTest>> dialogs_before_;  // those of the frame before
  bool tooltip_pending_ = false;
  bool moves_ = false;  // see want_frames()
  bool focuses_next_ = false;

  friend class UiFrame;
};

// Encloses a frame: empties the registry at the start, and forgets the mouse's resting place when it has
// left.
class UiFrame {
 public:
  explicit UiFrame(Ui& ui);
  ~UiFrame();
  UiFrame(const UiFrame&) = delete;
  UiFrame& operator=(const UiFrame&) = delete;

 private:
  Ui& ui_;
};

}  // namespace talus
