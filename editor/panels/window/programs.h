// The programs of others that a level can be opened in, by command lines that the user can change.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace talus {

enum class ProgramId { tic80, love, tiled };
inline constexpr std::size_t kProgramCount = 3;

struct ProgramInfo {
  ProgramId id;
  std::string_view key;       // in the settings: "tic80"
  std::string_view label;     // on screen: "TIC-80"
  std::string_view format;    // id of the exporter for it; a level whose file is of another format is opened
                              // as a copy. Empty: the level's own file, whatever it is
  std::string_view command;   // until the user changes it
  std::string_view settings;  // help for its field in the settings
};
const std::array<ProgramInfo, kProgramCount>& program_infos();

using ProgramCommands = std::array<std::string, kProgramCount>;  // by ProgramId; see split_command()
ProgramCommands default_program_commands();

}  // namespace talus
