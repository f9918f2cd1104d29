// CSV and Base64. Memory is allocated only when there is text for it.
#include "tiled_cells.h"

#include <charconv>

#include "../text/base64.h"
#include "../text/unpack.h"
#include "tiled_map.h"

namespace talus {
namespace {

using CellsResult = tl::expected<std::vector<std::uint32_t>, std::string>;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

CellsResult decode_csv(std::string_view data) {
  std::vector<std::uint32_t> cells;
  const char* at = data.data();
  const char* const end = at + data.size();
  const auto skip_blanks = [&] {
    while (at != end && is_blank(*at)) ++at;
  };
  for (skip_blanks(); at != end; skip_blanks()) {
    if (!cells.empty() && *at++ != ',') break;
    skip_blanks();
    if (at == end) return cells;  // a comma may follow the last number
    std::uint32_t cell = 0;
    const auto [next, problem] = std::from_chars(at, end, cell);
    if (problem != std::errc()) break;
    cells.push_back(cell);
    at = next;
  }
  if (at != end) return tl::unexpected("must have a number as cell " + std::to_string(cells.size() + 1));
  return cells;
}

tl::expected<std::string, std::string> unpacked_base64(std::string_view data) {
  auto bytes = decode_base64(data);
  if (bytes) return *std::move(bytes);
  return tl::unexpected(std::string("has a character that is not Base64"));
}

tl::expected<std::string, std::string> uncompressed(std::string bytes, std::string_view compression,
                                                    std::size_t limit) {
  if (compression.empty()) return bytes;
  const bool is_zstd = compression == "zstd";
  if (!is_zstd && compression != "zlib" && compression != "gzip")
    return tl::unexpected("has the unknown compression " + quoted_name(compression));
  auto content = is_zstd ? unpack_zstd(bytes, limit) : unpack_zlib(bytes, limit);
  if (content) return std::move(*content);
  return tl::unexpected(std::string(content.error().is_too_large ? "unpacks to more cells than the layer has"
                                                                 : "has compressed cells that are damaged"));
}

CellsResult cells_of_bytes(std::string_view bytes) {
  if (bytes.size() % 4 != 0) return tl::unexpected(std::string("ends in the middle of a cell"));
  std::vector<std::uint32_t> cells;
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    std::uint32_t cell = 0;
    for (std::size_t j = 4; j-- > 0;) cell = cell << 8 | static_cast<std::uint8_t>(bytes[i + j]);
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace

CellsResult decode_tiled_cells(std::string_view data, std::string_view encoding, std::string_view compression,
                               std::size_t count) {
  CellsResult cells;
  if (encoding == "csv") {
    cells = decode_csv(data);
  } else if (encoding == "base64") {
    cells = unpacked_base64(data)
                .and_then(
                    [&](std::string bytes) { return uncompressed(std::move(bytes), compression, 4 * count); })
                .and_then([](const std::string& bytes) { return cells_of_bytes(bytes); });
  } else {
    return tl::unexpected("has the unknown encoding " + quoted_name(encoding));
  }
  if (cells && cells->size() != count) return tl::unexpected(tiled_count_problem(cells->size(), count));
  return cells;
}

std::string encode_tiled_cells(std::span<const std::uint32_t> cells) {
  std::string bytes;
  bytes.reserve(4 * cells.size());
  for (const std::uint32_t cell : cells) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(cell >> shift & 0xff);
  }
  return encode_base64(pack_zlib(bytes));
}

std::string tiled_count_problem(std::size_t cells, std::size_t count) {
  return "has " + std::to_string(cells) + " cells, but needs " + std::to_string(count);
}

}  // namespace talus
