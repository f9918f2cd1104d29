// The export runs beside the window, and may ask first, so the start waits for it.
#include "game_start.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "external_program.h"

namespace talus {

std::optional<std::size_t> game_preset(const Level& level) {
  for (const std::string_view exporter : {"love", "bump"}) {
    const auto found = std::find_if(level.exports.begin(), level.exports.end(),
                                    [&](const ExportPreset& preset) { return preset.exporter == exporter; });
    if (found != level.exports.end()) return static_cast<std::size_t>(found - level.exports.begin());
  }
  return std::nullopt;
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
  if (!preset) {
    session.apply(action::ShowMessage{
        "The level has no preset for LÖVE, and no main.lua is in its folder: add a preset in File > Export.",
        true});
    return true;
  }
  if (!can_open(session, ProgramId::love, commands)) return true;
  if (session.modified() || session.path().empty()) session.apply(action::SaveFile{});
  if (session.modified() || session.path().empty()) return true;  // the session asks for something
  waiting_ = session.level().exports[*preset];
  is_exporting_ = false;
  return true;
}

void GameStart::follow(Session& session, const ProgramCommands& commands, OpenCopies& copies) {
  if (!waiting_ || session.exporting().is_busy() || session.question()) return;
  const auto preset = game_preset(session.level());
  if (!preset || session.level().exports[*preset] != *waiting_) return waiting_.reset();
  if (!is_exporting_) {
    is_exporting_ = true;
    return session.apply(action::RunExports{*preset});
  }
  const auto& run = session.exporting().last_run();
  const bool is_written = std::any_of(run.begin(), run.end(), [&](const ExportOutcome& outcome) {
    return outcome.written && outcome.task.preset == *waiting_;
  });
  waiting_.reset();
  if (is_written) open_in_program(session, ProgramId::love, commands, copies);
}

}  // namespace talus
