// The cells of a layer of Tiled, which come as text in several encodings.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace talus {

// encoding: "csv" or "base64"; compression: "", "zlib" or "gzip", of base64 alone. `count` cells must come of
// it; the error is the end of a sentence: "has 5 cells, and its size gives 6".
tl::expected<std::vector<std::uint32_t>, std::string> decode_tiled_cells(std::string_view data,
                                                                         std::string_view encoding,
                                                                         std::string_view compression,
                                                                         std::size_t count);

// Why there are not `count` cells, as above.
std::string tiled_count_problem(std::size_t cells, std::size_t count);

}  // namespace talus
