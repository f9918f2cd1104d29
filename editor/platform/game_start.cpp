// The export runs beside the window, and may ask first, so the start waits for it.
#include "game_start.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "edit/export_presets.h"
#include "external_program.h"
#include "user_folder.h"

namespace talus {

std::optional<std::size_t> game_preset(const Level& level) {
  const auto love = find_export(level, "love");
  return love ? love : find_export(level, "bump");
}

namespace {

// Whether the folder of the level is that of a game.
bool has_game_beside(const Session& session) {
  std::error_code unknown;
  return !session.path().empty() &&
         std::filesystem::exists(std::filesystem::path(session.path()).parent_path() / "main.lua", unknown);
}

}  // namespace

bool GameStart::begin(Session& session, const ProgramCommands& commands) {
  const auto preset = game_preset(session.level());
  if (!preset && has_game_beside(session)) return false;
  if (!can_open(session, ProgramId::love, commands)) return true;
  if (preset && session.path().empty()) session.apply(action::SaveFile{});  // the preset's path begins there
  own_folder_ = preset ? "" : (std::filesystem::path(state_folder()) / "game").string();
  waiting_ = preset ? session.level().exports[*preset] : preset_of_game(own_folder_);
  is_exporting_ = false;
  return true;
}

void GameStart::follow(Session& session, const ProgramCommands& commands) {
  if (!waiting_ || session.exporting().is_busy() || session.question() || session.wants_save_as()) return;
  if (own_folder_.empty() && session.path().empty()) return waiting_.reset();
  const auto preset = game_preset(session.level());
  const bool is_there =
      own_folder_.empty() ? preset && session.level().exports[*preset] == *waiting_ : !preset;
  if (!is_there) return waiting_.reset();
  if (!is_exporting_) {
    is_exporting_ = true;
    return session.apply(own_folder_.empty() ? Action(action::RunExports{*preset})
                                             : Action(action::ExportGame{own_folder_}));
  }
  const auto& run = session.exporting().last_run();
  const auto written = std::find_if(run.begin(), run.end(), [&](const ExportOutcome& outcome) {
    return outcome.written && outcome.task.preset == *waiting_;
  });
  waiting_.reset();
  if (written != run.end()) run_game(session, commands, written->output);
}

}  // namespace talus
