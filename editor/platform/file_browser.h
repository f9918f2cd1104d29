// The dialog that opens and saves files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/ui.h"

namespace talus {

class FileBrowser {
 public:
  enum class Purpose { open, save };
  struct Answer {
    bool cancelled = false;
    std::string path;  // absolute; empty when cancelled
  };

  // Draws the dialog while there is a purpose. When it appears it starts in the folder of `near`, or where it
  // was before if that is empty; for saving it suggests the name of `near`.
  std::optional<Answer> draw(std::optional<Purpose> purpose, const std::string& near, Ui& ui);
  // Shows why the answer did not work; until the next answer or folder.
  void show_error(std::string text) { error_ = std::move(text); }

 private:
  struct Entry {
    std::string name;
    bool is_folder = false;
  };
  void start(Purpose purpose, const std::string& near);
  void enter(const std::string& folder);
  void draw_place(Ui& ui);
  std::optional<Answer> draw_list(Ui& ui, float height);
  std::optional<Answer> draw_name(Ui& ui);
  void move_choice(int step);
  // Acts on the typed name: enters a folder, or answers with a file.
  std::optional<Answer> confirm();

  bool shown_ = false;
  Purpose purpose_ = Purpose::open;
  std::string folder_;  // absolute
  std::string name_;
  std::string error_;
  std::string overwrite_;  // the existing file that a second confirmation replaces
  std::vector<Entry> entries_;
  int chosen_ = -1;  // index of entries_; -1: none
  bool scroll_to_choice_ = false;
};

}  // namespace talus
