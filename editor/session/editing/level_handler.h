// LevelHandler: edits the open level, and tells the others what has changed in it.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "file_limits.h"
#include "level/picture_tiles.h"
#include "level_actions.h"
#include "open_level.h"
#include "session/checks/check_handler.h"
#include "session/choices/choice_handler.h"
#include "session/files/file_reader.h"
#include "session/messages/message_handler.h"
#include "session/run/run_handler.h"

namespace talus {

class LevelHandler {
 public:
  // reader: while it reads a file, which may replace the level, edits of the user are ignored.
  LevelHandler(OpenLevel& open, const FileReader& reader, RunHandler& run, CheckHandler& checks,
               ChoiceHandler& choices, MessageHandler& messages)
      : open_(open), reader_(reader), run_(run), checks_(checks), choices_(choices), messages_(messages) {}

  void apply(const LevelAction& action);

  // As EditLevel. Exports that the user changes become allowed. What paints on a locked or hidden layer is
  // refused with a message. What the open file cannot hold is asked about, once for each limit of it.
  void edit_by_user(const Edit& wanted, int stroke = 0);
  void edit(const Edit& wanted, int stroke = 0);  // by any part of the program
  void replace(Level opened);                     // opens another level, without a history
  void choose_first_tile() { choices_.choose_first_tile(); }
  // See UndoStack.
  void mark_saved() { open_.history.mark_saved(); }
  void forget_saved() { open_.history.forget_saved(); }
  // Paths of the pictures that the user allows to paint.
  const std::set<std::string>& painted_files() const { return painted_files_; }

 private:
  // For each action of LevelAction, in level_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  // Whether it asks before the edit is made, since the open file cannot hold it.
  bool asks_about_file(const Edit& wanted, int stroke);
  // Edits tiles whose pixels come from files, after a question for each of these.
  void edit_pictures(const PictureTiles& pictures, const Edit& wanted, int stroke);
  void ask_to_paint(const std::string& file, const Edit& wanted, int stroke);
  // Called for an edit that is done or undone: before it, and after it.
  bool wants_hidden_pixels(const Edit& edit) const;
  void note_edit(const Edit& edit);
  void note_layer(int before);  // before: index of the layer that was chosen
  void note_step_of_history();

  int begin_stroke() { return ++open_.last_stroke; }  // returns a number that no edit has yet
  PixelColor hole() const;                            // the colour that stays behind where pixels are lifted

  OpenLevel& open_;
  const FileReader& reader_;
  RunHandler& run_;
  CheckHandler& checks_;
  ChoiceHandler& choices_;
  MessageHandler& messages_;
  std::set<std::string> painted_files_;  // paths of the pictures that the user allows to paint
  std::set<TiledLimit> exceeded_;        // limits of the map that the user knows to be exceeded
  int pixel_stroke_ = 0;                 // for the moves of the selected pixels, while they float
};

}  // namespace talus
