// FileHandler: the file of the open level: opening, saving, and the questions about that; with the handlers
// of the pictures and the exports that belong to it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "export_handler.h"
#include "file_actions.h"
#include "file_reading.h"
#include "file_stamp.h"
#include "formats/native/companion.h"
#include "known_places.h"
#include "level/merge.h"
#include "level_import.h"
#include "map_list.h"
#include "opened_file.h"
#include "picture_handler.h"
#include "read_permissions.h"
#include "session/debugger/debug_handler.h"
#include "session/editing/level_handler.h"
#include "tile_import.h"
#include "unsaved_mappings.h"

namespace talus {

class FileHandler {
 public:
  // The parts that it works with.
  struct Parts {
    OpenLevel& open;
    FileReading& reading;
    LevelHandler& level;
    RunHandler& run;
    DebugHandler& debug;
    ChoiceHandler& choices;
    MessageHandler& messages;
  };
  // tools: for exports. name: for titles, while there is no file.
  FileHandler(const Parts& parts, ExportTools tools, std::string name);

  void apply(const FileAction& action);
  PictureHandler& pictures() { return pictures_; }
  ExportHandler& exports() { return exports_; }

  std::string file_name() const;   // for titles: "demo.talus.json"
  std::string file_names() const;  // with its companion
  // Whether the file, with its companion, holds everything of the level.
  bool is_stored() const { return open_.history.is_saved() && unstored_.empty(); }
  // See Session.
  const std::shared_ptr<const Level>& stored_level() const { return base_; }
  ImportChoices stored_choices() const { return choices_of(*base_, source_.choices); }
  int saves() const { return saves_; }
  int recoveries() const { return recoveries_; }
  // Waits for ApplyLevelImport or CancelLevelImport.
  const std::optional<LevelImport>& level_import() const { return level_import_; }
  // Waits for ApplyTiles or CancelTiles.
  const std::optional<TileImport>& tile_import() const { return tile_import_; }
  // The maps to go through.
  const MapList& maps() const { return maps_; }
  bool wants_save_as() const { return open_.wants_save_as; }
  bool wants_save_recording() const { return wants_save_recording_; }
  bool wants_quit() const { return wants_quit_; }

 private:
  // Actions that lose the changes since the last save, and so ask first.
  struct TakeNewLevel {  // made of a picture of tiles
    std::shared_ptr<const Level> level;
    std::string name;  // for titles
  };
  struct TakeImport {  // the level as the user has chosen it
    std::shared_ptr<LevelImport> import;
  };
  using DiscardingAction = std::variant<action::NewLevel, TakeNewLevel, TakeImport, action::OpenFile,
                                        action::RecoverLevel, action::Quit>;

  // For each action of FileAction, in file_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  void ask_before_discarding(DiscardingAction discarding);  // asks first if there are unsaved changes
  void answer_about_changes(action::Answer answer);
  void ask_about_unstored();
  void go_on_when_stored();
  void ask_about_branch(DiscardingAction discarding);  // the same for one with the user's marks or inputs
  void answer_about_branch(action::Answer answer);
  void continue_pending();
  void discard_and_do(const DiscardingAction& discarding);

  void note_reading_given_up();
  void read_and_open(const action::OpenFile& file);
  void take_opened(const action::OpenFile& file, OpenedFile opened);
  void apply_mapping(const Level& read);  // the level as the project gives it with another mapping
  void open_imported(const std::string& file, LoadedLevel loaded);
  void open_recording(const std::string& file, const Recording& recording, const EndScenes& scenes);
  void replace_level(Level opened, std::string opened_path, const Format* opened_format,
                     CompanionFile opened_companion = {});
  void recover(const action::RecoverLevel& saved);
  // file: the level as its own file has it. scenes: of the first recording.
  // The level with what another program has changed in its file since; the note is a sentence about that, or
  // empty.
  std::pair<Level, std::string> joined_with_file(const action::RecoverLevel& saved) const;
  void take_recovered(const action::RecoverLevel& saved, FormatResult<LoadedLevel> file,
                      const EndScenes& scenes);

  void take_import(LevelImport import);  // asks first: work may have been recovered since the file was read
  void open_import(LevelImport import);

  // --- Maps, by themselves and in folders; in map_opening.cpp
  // Lists them beside the window, if there are folders; then calls `use`. paths: not empty.
  void list_maps(const std::vector<std::string>& paths, bool deep, const std::function<void()>& use);
  void tell_place_in_list();
  // If the opened map has none. told: the message before it was opened.
  void offer_ground(const std::string& told);

  // --- Files outside of the map's folder; in outside_files.cpp
  ImportChoices with_permissions(const std::string& file, ImportChoices choices) const;
  // Whether the user is to be asked about these. refused: as in LoadedLevel.
  bool is_unasked(const std::string& file, const std::vector<std::string>& refused) const;
  // Reads everything again if the user allows them, or else goes on without them.
  void ask_about_outside(const std::string& file, const std::vector<std::string>& refused,
                         const std::function<void()>& read_again, const std::function<void()>& go_on);
  void read_import_again(const std::shared_ptr<LevelImport>& import);

  // --- Other programs change the files; in file_changes.cpp
  // Records the current content of the level's own files as known to this session. written: paths of other
  // files that were written with it.
  void note_file(const std::vector<std::string>& written = {});
  // What the level that was just opened came from.
  void note_source(const std::string& path, std::optional<LevelStamp> stamp, ImportChoices choices,
                   std::vector<std::string> dropped);
  struct Look;           // what has become of the files
  void look_at_files();  // beside the window's thread
  void take_look(const Look& look);
  void take_file_change(const FilesChange& found);  // reads, merges, asks or reports
  bool is_linked(const std::string& file) const;
  bool asks_about_tileset();
  // The files that saving the level may write: its own, tilesets, and painted pictures.
  std::vector<std::string> files_to_write() const;
  void note_places();  // where they lead, and pictures that may be painted later
  // Asks if one of them leads elsewhere than it did. go_on: what was to be done, after a yes.
  bool asks_about_link(const std::function<void()>& go_on);
  // Those that lead elsewhere than they did, and where they lead.
  std::vector<std::pair<std::string, std::string>> new_links() const;
  bool saves_into_newest(Level& saved);
  bool tell_of_redo();
  bool is_undecided_in_ldtk(const LoadedLevel& newer) const;
  void ask_to_read(const std::string& changed, const std::string& why);
  void reload();
  struct Newer;  // the level as its files have it now
  void take_reloaded(const std::shared_ptr<Newer>& newer);
  void take_unread(const Newer& newer, const std::string& why);
  void ask_about_merge(const std::shared_ptr<Newer>& newer, const MergedLevel& merged);
  void take_newer(const Newer& newer, Level level);
  bool save();  // returns false if it failed or needs a name first
  bool save_to(const std::string& saved_path, const Format& saved_format);

  OpenLevel& open_;
  FileReading& reading_;
  LevelHandler& level_;
  RunHandler& run_;
  DebugHandler& debug_;
  MessageHandler& messages_;
  ReadPermissions reads_;
  UnsavedMappings mappings_;
  PictureHandler pictures_;
  ExportHandler exports_;

  std::string name_;  // for titles, while there is no file
  int saves_ = 0;
  // What the level was read from, also if it cannot be saved there.
  struct Source {
    std::string path;                  // empty: no file
    ImportChoices choices;             // with which it was read
    std::vector<std::string> dropped;  // what it could not keep then
  };
  Source source_;
  std::shared_ptr<const Level> base_;  // as its files had it when they were last read or written
  // The files of the source when they were last read, written or asked about; nothing: no file.
  std::optional<LevelStamp> stamp_;
  KnownPlaces places_;                 // of the files that saving writes
  CompanionFile companion_;            // the companion that the level was last read or written with
  std::vector<std::string> unstored_;  // the parts of the saved level that the file lacks, one phrase each

  std::string unread_for_;  // the file for which the user has declined to read files outside; empty: none
  std::optional<LevelImport> level_import_;
  std::optional<TileImport> tile_import_;
  MapList maps_;
  std::optional<DiscardingAction>
      pending_;  // waits for the question's answer, or for the saving that it led to
  bool wants_save_recording_ = false;
  bool wants_quit_ = false;

  int recoveries_ = 0;
  std::optional<LevelStamp>
      declined_;                  // of changed files that the user does not want to hear of until saving
  bool is_reloading_ = false;     // whether changed files are being compared or read
  bool has_given_up_ = false;     // whether that was cancelled: only an answer begins it again
  bool is_saving_ = false;        // whether the files are read because they are to be saved
  bool saves_when_read_ = false;  // whether saving goes on when they are read
  int failures_ = 0;              // how often in a row they could not be read
};

}  // namespace talus
