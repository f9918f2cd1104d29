// TIC-80 cartridges, `.tic`: chunks one after another, each a header of four bytes and its data.
//
// Reading takes bank 0 into the level and keeps the whole file as its origin. Writing a level with such an
// origin copies every chunk that the level did not change, replaces changed sections, inserts new ones where
// TIC-80 would write them, and leaves out sections that became empty. So an untouched file comes back byte
// for byte. A level of another origin is written as TIC-80 writes carts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>
#include "cart_content.h"

namespace talus {

// The types of chunks that are not a section of cart_content.h.
enum TicChunkType : int {
  kTicCover = 3,
  kTicCode = 5,
  kTicCodeZip = 16,
  kTicDefault = 17,
  kTicBinary = 19,
  kTicLang = 20
};

struct TicChunk {
  int type = 0;               // 0..31
  int bank = 0;               // 0..7
  std::uint8_t reserved = 0;  // last byte of the header; TIC-80 writes 0 and ignores it
  std::size_t offset = 0;     // of the header, in the file
  std::string_view data = {};
};

// Returns TIC-80's name for a chunk type, such as "SAMPLES"; empty for an unknown type.
std::string_view tic_chunk_name(int type);

FormatResult<std::vector<TicChunk>> parse_tic(std::string_view bytes);
// data: at most kBankBytes for CODE and BINARY, whose full size is stored as 0; else at most 65535
// (asserted).
void append_tic_chunk(std::string& out, const TicChunk& chunk);

// progress: may stop the reading, which is an error.
FormatResult<CartContent> tic_content(std::string_view bytes, const Progress& progress = {});
// Returns a cartridge with this content, as TIC-80 writes it, without `lang` and `rest`. The code may have up
// to kCodeLimit bytes.
std::string tic_bytes(const CartContent& cart);
// Returns the cart with the level's sections in it, as described above. A map that does not fit leaves the
// cart's map.
FormatResult<std::string> edited_tic(std::string_view bytes, const Level& level);

bool accepts_tic(std::string_view bytes, const FormatContext& context);
FormatResult<Level> read_tic(std::string_view bytes, const FormatContext& context);
FormatResult<WrittenLevel> write_tic(const Level& level, const FormatContext& context);

}  // namespace talus
