// TIC-80 text projects: code, then sections of comment lines with hexadecimal rows.
//
// Reading takes bank 0 into the level and keeps the whole file as its origin. Writing such a level with the
// same comment prefix rewrites only the lines of the sections that the level changed; every other byte stays,
// "\r
// " too. A new section goes where TIC-80 would write it. Any other level is written as TIC-80 does.
//
// As in TIC-80, the code ends at the first line after the first one that starts with "-- <" (or another
// prefix), whatever follows. Sections are looked for at the starts of lines behind it. TIC-80 takes the first
// occurrence of a tag anywhere, so a file in which that would be another place is refused. Of two sections
// with one tag the first counts. Rows are numbered from 0, may come in any order, and are never shorter than
// those of their section.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>
#include "cart_content.h"

namespace talus {

// Returns TIC-80's comment prefix for files with this extension: "--" for "lua"; empty if unknown.
std::string_view comment_of_extension(std::string_view extension);
std::span<const std::string_view> text_extensions();

// One section of a text project as byte offsets: the line of its open tag, its rows, the line of its close
// tag, and an empty line.
struct TextSection {
  std::string tag;                    // "MAP1"
  const SectionInfo* info = nullptr;  // null for LANG
  int bank = 0;                       // 0..7, from the tag
  std::size_t begin = 0;              // of the open tag's line
  std::size_t rows = 0;               // of the first row
  std::size_t rows_end = 0;           // behind the last row: the close tag's line
  std::size_t end = 0;                // behind the section and its empty line
};

struct TextProject {
  std::string_view code;              // with the carriage returns of its lines
  std::vector<TextSection> sections;  // in the order of the file
  int strays = 0;                     // lines with text behind the code that belong to no section
};

FormatResult<TextProject> parse_text(std::string_view bytes, std::string_view comment);
FormatResult<CartContent> text_content(std::string_view bytes, std::string_view comment);
// The rows of a section that are not all zero, one on each line.
std::string text_rows(const SectionInfo& info, std::string_view data, std::string_view comment,
                      std::string_view newline);
// Returns the project with the level's sections in it, as described above. A map that does not fit leaves the
// project's map.
FormatResult<std::string> edited_text(const CartOrigin& origin, const Level& level);

bool accepts_text(std::string_view bytes, const FormatContext& context);
FormatResult<Level> read_text(std::string_view bytes, const FormatContext& context);
FormatResult<WrittenLevel> write_text(const Level& level, const FormatContext& context);

}  // namespace talus
