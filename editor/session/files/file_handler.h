// FileHandler: the file of the open level: opening, saving, and the questions that they lead to.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "export_handler.h"
#include "file_actions.h"
#include "file_reading.h"
#include "file_stamp.h"
#include "formats/native/companion.h"
#include "level_import.h"
#include "opened_file.h"
#include "picture_handler.h"
#include "session/debugger/debug_handler.h"
#include "session/editing/level_handler.h"

namespace talus {

class FileHandler {
 public:
  // What it works with.
  struct Parts {
    OpenLevel& open;
    FileReading& reading;
    LevelHandler& level;
    RunHandler& run;
    DebugHandler& debug;
    PictureHandler& pictures;
    ExportHandler& exports;
    ExportPermissions& permissions;
    MessageHandler& messages;
  };
  // name: for titles, while there is no file.
  FileHandler(const Parts& parts, std::string name);

  void apply(const FileAction& action);

  std::string file_name() const;   // for titles: "demo.talus.json"
  std::string file_names() const;  // with its companion
  // Whether the file, with its companion, holds all that is here.
  bool is_stored() const { return open_.history.is_saved() && unstored_.empty(); }
  int saves() const { return saves_; }
  int recoveries() const { return recoveries_; }
  // Waits for ApplyLevelImport or CancelLevelImport.
  const std::optional<LevelImport>& level_import() const { return level_import_; }
  bool wants_save_as() const { return wants_save_as_; }
  bool wants_save_recording() const { return wants_save_recording_; }
  bool wants_quit() const { return wants_quit_; }

 private:
  // What loses the changes since the last save, and so is asked about first.
  using DiscardingAction =
      std::variant<action::NewLevel, action::OpenFile, action::RecoverLevel, action::Quit>;

  // For each action of FileAction: in file_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  void ask_before_discarding(DiscardingAction discarding);  // asks first if there are unsaved changes
  void answer_about_changes(action::Answer answer);
  void ask_about_unstored();
  void go_on_when_stored();
  void ask_about_run(DiscardingAction discarding);  // the same of a run with the user's marks or inputs
  void answer_about_run(action::Answer answer);
  void continue_pending();
  void discard_and_do(const DiscardingAction& discarding);

  void note_reading_given_up();
  void read_and_open(const action::OpenFile& file);
  void take_opened(const action::OpenFile& file, OpenedFile opened);
  void open_imported(const std::string& file, LoadedLevel loaded);
  void open_recording(const std::string& file, const Recording& recording, const EndScenes& scenes);
  void replace_level(Level opened, std::string opened_path, const Format* opened_format,
                     CompanionFile opened_companion = {});
  void recover(const action::RecoverLevel& saved);
  // file: the level as its own file has it. scenes: of the first recording.
  void take_recovered(const action::RecoverLevel& saved, FormatResult<LoadedLevel> file,
                      const EndScenes& scenes);

  // Notes what the level's file holds now, as what this session knows of it.
  void note_file();
  void take_file_change(FilesChange found);  // by another program; asks or tells what becomes of the level
  void reload();
  void take_reloaded(const FormatResult<LoadedLevel>& loaded);
  bool save();  // false when it failed or a name is needed first
  bool save_to(const std::string& saved_path, const Format& saved_format);

  OpenLevel& open_;
  FileReading& reading_;
  LevelHandler& level_;
  RunHandler& run_;
  DebugHandler& debug_;
  PictureHandler& pictures_;
  ExportHandler& exports_;
  ExportPermissions& permissions_;
  MessageHandler& messages_;

  std::string name_;  // for titles, while there is no file
  int saves_ = 0;
  // Of the files as they were read, written or asked about last; none: no file.
  std::optional<LevelStamp> stamp_;
  CompanionFile companion_;            // that the level was read or written with last
  std::vector<std::string> unstored_;  // what the file lacks of the saved level, one phrase each
  const Format* format_ = nullptr;     // that the file is in; null: none, or an unknown one

  std::optional<LevelImport> level_import_;
  std::optional<DiscardingAction>
      pending_;  // waits for the question's answer, or for the saving that it led to
  bool wants_save_as_ = false;
  bool wants_save_recording_ = false;
  bool wants_quit_ = false;

  int recoveries_ = 0;
  std::optional<LevelStamp> changed_from_;  // `stamp_` as it was before another program changed the file
  bool is_reloading_ = false;               // what is being read is that file
};

}  // namespace talus
