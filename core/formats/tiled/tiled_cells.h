// The cells of a Tiled layer, which are text in several encodings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace talus {

// encoding: "csv" or "base64". compression: "", "zlib", "gzip" or "zstd", for base64 only. The text must hold
// `count` cells. The error is the end of a sentence: "has 5 cells, but needs 6".
tl::expected<std::vector<std::uint32_t>, std::string> decode_tiled_cells(std::string_view data,
                                                                         std::string_view encoding,
                                                                         std::string_view compression,
                                                                         std::size_t count);

// Cells that maps are written with as a list of numbers, which people can read; more are packed.
inline constexpr std::size_t kMaxListedCells = std::size_t{1} << 20;

// How the cells of a layer are written, by the words of decode_tiled_cells(). Without an encoding they are a
// list of numbers.
struct TiledEncoding {
  std::string encoding, compression;
};
// Returns the text of other cells in place of `old`, whose blanks and line breaks it keeps. width: cells of a
// row. line_end: of new lines. The text of a list has no brackets.
std::string recode_tiled_cells(std::string_view old, const TiledEncoding& how,
                               std::span<const std::uint32_t> cells, int width, std::string_view line_end);

// The cells as "base64", compressed by "zlib".
std::string encode_tiled_cells(std::span<const std::uint32_t> cells);

// Why there are not `count` cells, in the words above.
std::string tiled_count_problem(std::size_t cells, std::size_t count);

}  // namespace talus
