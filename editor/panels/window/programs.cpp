// The list of other programs.
#include "programs.h"

namespace talus {

const std::array<ProgramInfo, kProgramCount>& program_infos() {
  static constexpr std::array<ProgramInfo, kProgramCount> kInfos = {{
      {ProgramId::tic80, "tic80", "TIC-80", "tic", "tic80 {file}",
       "What opens a cart. {file} stands for the file, {folder} for its folder; no shell is in between."},
      {ProgramId::love, "love", "LÖVE", "", "love {folder}",
       "What runs the level's game. {folder} stands for the folder that its first preset of a game for LÖVE "
       "writes, or else for that of the level's file, {file} for the level's file."},
      {ProgramId::tiled, "tiled", "Tiled", "tmj", "tiled {file}",
       "What opens a map of Tiled. {file} stands for the file, {folder} for its folder."},
  }};
  return kInfos;
}

ProgramCommands default_program_commands() {
  ProgramCommands commands;
  for (const ProgramInfo& info : program_infos())
    commands[static_cast<std::size_t>(info.id)] = std::string(info.command);
  return commands;
}

}  // namespace talus
