// CSV and Base64. Memory is allocated only when there is text for it.
#include "tiled_cells.h"

#include <algorithm>
#include <charconv>
#include <optional>

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

std::string bytes_of_cells(std::span<const std::uint32_t> cells) {
  std::string bytes;
  bytes.reserve(4 * cells.size());
  for (const std::uint32_t cell : cells) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(cell >> shift & 0xff);
  }
  return bytes;
}

std::string packed_cells(std::span<const std::uint32_t> cells, std::string_view compression) {
  const std::string bytes = bytes_of_cells(cells);
  if (compression == "zlib") return encode_base64(pack_zlib(bytes));
  if (compression == "gzip") return encode_base64(pack_gzip(bytes));
  if (compression == "zstd") return encode_base64(pack_zstd(bytes));
  return encode_base64(bytes);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The list with other numbers in the places of the old ones; nothing if it does not have as many.
std::optional<std::string> with_numbers(std::string_view old, std::span<const std::uint32_t> cells) {
  std::string text;
  std::size_t at = 0, count = 0;
  while (at < old.size()) {
    const char c = old[at];
    if (!is_digit(c) && !is_blank(c) && c != ',') return std::nullopt;
    const std::size_t begin = at;
    while (at < old.size() && is_digit(old[at])) ++at;
    if (begin == at) {
      text += old[at++];
    } else if (count == cells.size()) {
      return std::nullopt;
    } else {
      text += std::to_string(cells[count++]);
    }
  }
  if (count != cells.size()) return std::nullopt;
  return text;
}

// A new list, a row a line unless the old one had no line breaks.
std::string listed_cells(std::string_view old, std::span<const std::uint32_t> cells, int width,
                         std::string_view line_end) {
  const bool has_lines = old.find('\n') != old.npos || old.find_first_of("0123456789") == old.npos;
  const bool has_own = old.find('\n') != old.npos;
  const std::string_view own_end = old.find("\r\n") != old.npos ? "\r\n" : "\n";
  const std::string_view row_end = has_own ? own_end : has_lines ? line_end : "";
  std::string text(row_end);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text += ',';
    if (i > 0 && i % static_cast<std::size_t>(width) == 0) text += row_end;
    text += std::to_string(cells[i]);
  }
  return text.append(row_end);
}

}  // namespace

std::string recode_tiled_cells(std::string_view old, const TiledEncoding& how,
                               std::span<const std::uint32_t> cells, int width, std::string_view line_end) {
  if (how.encoding != "base64") {
    auto text = with_numbers(old, cells);
    return text ? *std::move(text) : listed_cells(old, cells, width, line_end);
  }
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = std::min(old.find_first_not_of(kBlanks), old.size());
  const std::size_t last = first == old.size() ? first : old.find_last_not_of(kBlanks) + 1;
  return std::string(old.substr(0, first)) + packed_cells(cells, how.compression) +
         std::string(old.substr(last));
}

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

std::string encode_tiled_cells(std::span<const std::uint32_t> cells) { return packed_cells(cells, "zlib"); }

std::string tiled_count_problem(std::size_t cells, std::size_t count) {
  return "has " + std::to_string(cells) + " cells, but needs " + std::to_string(count);
}

}  // namespace talus
