// The cells of a Tiled layer, which are text in several encodings.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace talus {

// encoding: "csv" or "base64". compression: "", "zlib" or "gzip", for base64 only. The text must hold `count`
// cells. The error is the end of a sentence: "has 5 cells, but needs 6".
tl::expected<std::vector<std::uint32_t>, std::string> decode_tiled_cells(std::string_view data,
                                                                         std::string_view encoding,
                                                                         std::string_view compression,
                                                                         std::size_t count);

// Why there are not `count` cells, in the words above.
std::string tiled_count_problem(std::size_t cells, std::size_t count);

}  // namespace talus
