// What commands may write over: never what they read, and never a file of another kind.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace talus {

struct OutputFile {
  std::string path;                 // as it was typed
  std::string_view bytes;           // that will be written, or their beginning: at least a line
  std::vector<std::string> inputs;  // files that the command reads; empty ones are none
  // Whether a file that is there may be of a kind which nobody knows, as where it was named to be replaced.
  bool may_be_unknown = false;
};

// One sentence without its full stop on why the command must not write there; empty: it may. Links and other
// names of a file are seen through; devices and pipes may always be written.
std::string output_problem(const OutputFile& output);

// The same of a name: "is not a name for a PNG picture: it must end with .png". ending: without the dot.
std::string ending_problem(const std::string& path, std::string_view ending, std::string_view kind);

// Whether a name says that a file is a level, a map, a cart or a recording. ".json" alone says nothing.
bool has_name_of_level(const std::string& path);

// What the bytes of a file are, by their content: "TIC-80 cartridge", "PNG picture", "trace of a simulation".
// Empty: nobody knows, as of any text.
std::string_view content_kind(std::string_view bytes);

// What the beginnings of these files are.
inline constexpr std::string_view kPngBeginning = "\x89PNG\r\n\x1a\n";
inline constexpr std::string_view kTraceBeginning = "{\"frame\":";

}  // namespace talus
