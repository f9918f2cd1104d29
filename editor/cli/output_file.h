// Which files commands may overwrite: never one that they read, and never one of another kind.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace talus {

struct OutputFile {
  std::string path;                 // as it was typed
  std::string_view bytes;           // that will be written, or at least their first line
  std::vector<std::string> inputs;  // files that the command reads; empty names are ignored
  // Whether a file of unknown kind may be replaced, because the user has named it for that.
  bool may_be_unknown = false;
};

// Whether a path leads to one of these files, to the companion of one, or to the file that one is a companion
// of. Links and other names of a file are recognised.
bool is_one_of(const std::vector<std::string>& files, const std::string& path);

// One sentence without its full stop on why the command must not write there; empty if it may. Links and
// other names of a file are followed. Devices and pipes may always be written.
std::string output_problem(const OutputFile& output);

// The same for a name: "is not a name for a PNG picture: it must end with .png". ending: without the dot.
std::string ending_problem(const std::string& path, std::string_view ending, std::string_view kind);

// Whether a name is that of a level, a map, a cart or a recording. ".json" alone is not.
bool has_name_of_level(const std::string& path);

// The kind of a file by its content: "TIC-80 cartridge", "PNG picture", "trace of a simulation". Empty if it
// is unknown, as for any text.
std::string_view content_kind(std::string_view bytes);

// The beginnings of these files.
inline constexpr std::string_view kPngBeginning = "\x89PNG\r\n\x1a\n";
inline constexpr std::string_view kTraceBeginning = "{\"frame\":1,\"bodies\":[";

}  // namespace talus
