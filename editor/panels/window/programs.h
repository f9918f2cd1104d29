// Other programs that can open a level, by command lines that the user can change.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace talus {

enum class ProgramId { tic80, love, tiled };
inline constexpr std::size_t kProgramCount = 3;

struct ProgramInfo {
  ProgramId id;
  std::string_view key;    // in the settings: "tic80"
  std::string_view label;  // on screen: "TIC-80"
  // Id of its exporter; a level whose file has another format is opened as a copy. Empty: it opens the
  // level's own file, whatever the format.
  std::string_view format;
  std::string_view command;   // until the user changes it
  std::string_view settings;  // help for its field in the settings
};
const std::array<ProgramInfo, kProgramCount>& program_infos();

using ProgramCommands = std::array<std::string, kProgramCount>;  // by ProgramId; see split_command()
ProgramCommands default_program_commands();

}  // namespace talus
