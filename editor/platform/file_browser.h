// The dialog that opens and saves files.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "file_request.h"
#include "panels/ui/ui.h"

namespace talus {

class FileBrowser {
 public:
  struct Answer {
    bool cancelled = false;
    std::string path;  // absolute; empty when cancelled
  };

  // Draws the dialog while there is a request, which is as long as `wanted` holds. When it appears it starts
  // in the folder of `near`, or where it was before if that is empty; for saving it suggests the name of
  // `near`.
  std::optional<Answer> draw(const std::optional<FileRequest>& request, DialogTest wanted,
                             const Session& session, Ui& ui);
  // Shows why the answer did not work; until the next answer or folder.
  void show_error(std::string text) { error_ = std::move(text); }

 private:
  struct Entry {
    std::string name;
    bool is_folder = false;
  };
  void start(const FileRequest& request);
  bool lists(const std::string& name) const;
  std::string known_endings() const;
  void enter(const std::string& folder);
  // The folders that the user keeps, and those of the files that were open last.
  void draw_places(Ui& ui, ImVec2 size);
  std::optional<Answer> draw_list(Ui& ui, ImVec2 size);
  void draw_picture(Ui& ui);
  // Of the chosen file, if one is known.
  std::shared_ptr<const SheetPicture> picture_of_choice(const Ui& ui);
  std::optional<Answer> draw_name(Ui& ui);
  // Goes to a folder; a name to save under stays.
  void go_to(const std::string& folder);
  // Indices of the entries that hold the typed text; all of them if it is empty or a path.
  std::vector<int> listed_entries() const;
  void move_choice(int step);
  // Acts on the typed name: enters a folder, or answers with a file.
  std::optional<Answer> confirm();

  bool shown_ = false;
  FileRequest request_;
  std::string folder_;  // absolute
  std::string name_;
  bool wants_name_ = false;        // another folder is shown: the next letters go to the name
  bool is_name_proposed_ = false;  // nobody has clicked into it: the first click selects all of it
  std::string error_;
  std::string overwrite_;  // the existing file that a second confirmation replaces
  std::vector<Entry> entries_;
  int chosen_ = -1;                              // index of entries_; -1: none
  std::optional<std::string> chosen_name_;       // of the entry that a key has chosen in this frame
  std::string filter_;                           // what was typed; only entries that hold it are listed
  std::string pictured_;                         // path of picture_
  std::shared_ptr<const SheetPicture> picture_;  // of a file that is one; null: it cannot be read
  bool scroll_to_choice_ = false;
};

}  // namespace talus
