// Carts as JSON. A section that the level owns is named, not stored.
#include "native_cart.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "../text/hex.h"
#include "../text/utf8_text.h"
#include "../tic80/tic_cart.h"
#include "../tic80/tic_text.h"

namespace talus {
namespace {

constexpr std::size_t kDataRow = 64;  // bytes in each row, if the chunk has no rows of its own
// A text of more lines is not meant for people, and is stored as data: each line costs memory in reading.
constexpr std::ptrdiff_t kMaxLines = 262'144, kMaxChunkLines = 16'384;

tl::unexpected<FormatError> error_at(const std::string& key, std::string message) {
  return tl::unexpected(FormatError{"key " + key, std::move(message)});
}

Json hex_rows(std::string_view bytes, std::size_t row_bytes) {
  Json rows = Json::array();
  for (std::size_t at = 0; at < bytes.size(); at += row_bytes)
    rows.push_back(to_hex(bytes.substr(at, row_bytes)));
  return rows;
}

Json text_lines(std::string_view text) {
  Json lines = Json::array();
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

bool is_text(std::string_view bytes, std::ptrdiff_t most_lines) {
  return std::count(bytes.begin(), bytes.end(), '\n') < most_lines && is_utf8(bytes);
}

FormatResult<std::string> bytes_of_hex(const Json& rows, const std::string& key) {
  if (!rows.is_array()) return error_at(key, "must be a list of rows of hexadecimal digits");
  std::string bytes;
  for (const Json& row : rows) {
    if (!row.is_string()) return error_at(key, "must be a list of rows of hexadecimal digits");
    const std::string& text = row.get_ref<const std::string&>();
    for (std::size_t i = 0; i < text.size(); i += 2) {
      const int high = hex_value(text[i]), low = i + 1 < text.size() ? hex_value(text[i + 1]) : -1;
      if (high < 0 || low < 0) return error_at(key, "has a row that is not pairs of hexadecimal digits");
      bytes += static_cast<char>(high << 4 | low);
    }
  }
  return bytes;
}

// The section of the level that a chunk or tag of bank 0 holds; null if the level does not own it.
const SectionInfo* level_section(const Level& level, int bank, const auto& matches) {
  for (const Section id : kLevelSections) {
    const SectionInfo& info = section_info(id);
    if (bank == 0 && matches(info) && (id != Section::map || map_fits_cart(level))) return &info;
  }
  return nullptr;
}
const SectionInfo* level_section(const Level& level, const TicChunk& chunk) {
  return level_section(level, chunk.bank, [&](const SectionInfo& info) { return info.chunk == chunk.type; });
}

Json json_of_chunk(const Level& level, const TicChunk& chunk) {
  Json json = Json::object();
  const std::string_view name = tic_chunk_name(chunk.type);
  json["chunk"] = name.empty() ? Json(chunk.type) : Json(name);
  if (chunk.bank != 0) json["bank"] = chunk.bank;
  if (chunk.reserved != 0) json["reserved"] = chunk.reserved;
  if (chunk.data.empty()) return json;
  const SectionInfo* own = level_section(level, chunk);
  if (own && section_bytes(level, own->id) == chunk.data) {
    json["data"] = "level";
  } else if (chunk.type == kTicCode && is_text(chunk.data, kMaxChunkLines)) {
    json["code"] = text_lines(chunk.data);
  } else {
    const auto infos = section_infos();
    const auto info =
        std::find_if(infos.begin(), infos.end(), [&](const auto& i) { return i.chunk == chunk.type; });
    json["data"] =
        hex_rows(chunk.data, info == infos.end() ? kDataRow : static_cast<std::size_t>(info->row_bytes));
  }
  return json;
}

void put_text(const Level& level, std::string_view bytes, std::string_view comment, Json& cart) {
  cart["comment"] = comment;
  const auto project = parse_text(bytes, comment);
  if (!project || !is_text(bytes, kMaxLines)) {
    cart["data"] = hex_rows(bytes, kDataRow);
    return;
  }
  Json lines = Json::array();
  std::size_t done = 0;
  const auto add_lines = [&](std::size_t end) {
    for (Json& line : text_lines(bytes.substr(done, end - done))) lines.push_back(std::move(line));
  };
  for (const TextSection& section : project->sections) {
    const SectionInfo* own =
        level_section(level, section.bank, [&](const auto& i) { return section.info == &i; });
    const std::string_view rows = bytes.substr(section.rows, section.rows_end - section.rows);
    if (!own || text_rows(*own, section_bytes(level, own->id), comment, "\n") != rows || rows.empty())
      continue;
    add_lines(section.rows - 1);  // the line break of the open tag separates two lines
    lines.push_back({{"level", own->tag}});
    done = section.rows_end;
  }
  add_lines(bytes.size());
  cart["lines"] = std::move(lines);
}

// One line, or the rows that it stands for, without the last line break.
FormatResult<std::string> text_of_line(const Json& line, const Level& level, const std::string& comment,
                                       const std::string& key) {
  if (line.is_string()) return line.get<std::string>();
  for (auto it = line.begin(); line.is_object() && it != line.end(); ++it)
    if (it.key() != "level") return error_at(key, "has the key \"" + it.key() + "\", which no line has");
  const bool named =
      line.is_object() && line.size() == 1 && line.contains("level") && line["level"].is_string();
  if (!named) return error_at(key, "must be a string or {\"level\": SECTION}");
  const std::string& tag = line["level"].get_ref<const std::string&>();
  const SectionInfo* own = level_section(level, 0, [&](const SectionInfo& info) { return info.tag == tag; });
  if (!own)
    return error_at(key,
                    "names a section that the level does not have, or a map that is too large for a cart");
  std::string rows = text_rows(*own, section_bytes(level, own->id), comment, "\n");
  if (!rows.empty()) rows.pop_back();
  return rows;
}

FormatResult<std::string> take_lines(const Json& lines, const Level& level, const std::string& comment) {
  if (!lines.is_array()) return error_at("cart.lines", "must be a list");
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto line = text_of_line(lines[i], level, comment, "cart.lines[" + std::to_string(i) + "]");
    if (!line) return line;
    if (i > 0) text += '\n';
    text += *line;
    if (text.size() > kMaxCartBytes)
      return error_at("cart.lines", "make the cart larger than 4 MiB, the limit for carts");
  }
  return text;
}

FormatResult<std::string> code_of(const Json& lines, const std::string& key) {
  if (!lines.is_array()) return error_at(key, "must be a list of lines");
  std::string code;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].is_string()) return error_at(key, "must be a list of lines");
    if (i > 0) code += '\n';
    code += lines[i].get_ref<const std::string&>();
  }
  return code;
}

int chunk_type(const Json& json) {
  for (int type = 0; type < 32; ++type) {
    if (json == Json(type) || (json.is_string() && !json.get_ref<const std::string&>().empty() &&
                               json.get_ref<const std::string&>() == tic_chunk_name(type))) {
      return type;
    }
  }
  return -1;
}

// A whole number in 0..max; `fallback` if the key is missing, -1 for anything else.
int small_number(const Json& object, const char* key, int fallback, int max) {
  if (!object.contains(key)) return fallback;
  const Json& json = object[key];
  if (!is_whole(json, 0, max)) return -1;
  return json.get<int>();
}

FormatResult<std::string> chunk_data(const Json& json, const TicChunk& chunk, const Level& level,
                                     const std::string& key) {
  if (json.contains("code")) return code_of(json["code"], key + ".code");
  if (!json.contains("data")) return std::string();
  if (json["data"] != "level") return bytes_of_hex(json["data"], key + ".data");
  const SectionInfo* own = level_section(level, chunk);
  if (!own)
    return error_at(key + ".data",
                    "names a section that the level does not have, or a map that is too large for a cart");
  return section_bytes(level, own->id);
}

FormatResult<void> append_chunk(std::string& bytes, const Json& json, const Level& level,
                                const std::string& key) {
  if (!json.is_object()) return error_at(key, "must be an object");
  for (auto it = json.begin(); it != json.end(); ++it) {
    constexpr std::array<std::string_view, 5> kKeys = {"chunk", "bank", "reserved", "code", "data"};
    if (std::find(kKeys.begin(), kKeys.end(), it.key()) == kKeys.end()) {
      return error_at(key, "has the key \"" + it.key() + "\", which no chunk has");
    }
  }
  TicChunk chunk = {.type = json.contains("chunk") ? chunk_type(json["chunk"]) : -1};
  if (chunk.type < 0)
    return error_at(key + ".chunk", "must be the name of a chunk, or its number from 0 to 31");
  chunk.bank = small_number(json, "bank", 0, kBankCount - 1);
  if (chunk.bank < 0) return error_at(key + ".bank", "must be a whole number from 0 to 7");
  const int reserved = small_number(json, "reserved", 0, 255);
  if (reserved < 0) return error_at(key + ".reserved", "must be a whole number from 0 to 255");
  chunk.reserved = static_cast<std::uint8_t>(reserved);
  const auto data = chunk_data(json, chunk, level, key);
  if (!data) return tl::unexpected(data.error());
  chunk.data = *data;
  const bool is_piece = chunk.type == kTicCode || chunk.type == kTicBinary;
  if (data->size() > kBankBytes - (is_piece ? 0 : 1) || (is_piece && data->empty())) {
    return error_at(key,
                    "has " + std::to_string(data->size()) + " bytes, which a chunk's header cannot express");
  }
  append_tic_chunk(bytes, chunk);
  return {};
}

FormatResult<std::string> take_chunks(const Json& chunks, const Level& level) {
  if (!chunks.is_array()) return error_at("cart.chunks", "must be a list");
  std::string bytes;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const std::string key = "cart.chunks[" + std::to_string(i) + "]";
    if (const auto good = append_chunk(bytes, chunks[i], level, key); !good)
      return tl::unexpected(good.error());
    if (bytes.size() > kMaxCartBytes)
      return error_at(key, "makes the cart larger than 4 MiB, the limit for carts");
  }
  return bytes;
}

Json take(Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  Json value = std::move(*found);
  object.erase(found);
  return value;
}

}  // namespace

void put_cart(const Level& level, Json& cart) {
  assert(level.cart);
  const CartOrigin& origin = *level.cart;
  const bool is_tic = origin.kind == CartOrigin::Kind::tic;
  cart["kind"] = is_tic ? "tic" : "text";
  const auto edited = is_tic ? edited_tic(origin.bytes, level) : edited_text(origin, level);
  // A cartridge that the edits would empty or make too large stays as it was, and so does a text project
  // whose code does not allow them. The level itself holds the edits.
  const bool usable = edited && !(is_tic && edited->empty()) && edited->size() <= kMaxCartBytes;
  const std::string& bytes = usable ? *edited : origin.bytes;
  if (!is_tic) return put_text(level, bytes, origin.comment, cart);
  Json chunks = Json::array();
  for (const TicChunk& chunk : parse_tic(bytes).value_or(std::vector<TicChunk>())) {
    chunks.push_back(json_of_chunk(level, chunk));
  }
  cart["chunks"] = std::move(chunks);
}

FormatResult<std::shared_ptr<const CartOrigin>> take_cart(Json& cart, const Level& level) {
  const Json kind = take(cart, "kind");
  CartOrigin origin;
  FormatResult<std::string> bytes;
  FormatResult<CartContent> content;
  if (kind == "tic") {
    bytes = take_chunks(take(cart, "chunks"), level);
    if (bytes) content = tic_content(*bytes);
  } else if (kind == "text") {
    origin.kind = CartOrigin::Kind::text;
    const Json comment = take(cart, "comment");
    const bool known = comment == "--" || comment == "//" || comment == ";;" || comment == "#";
    if (!known) return error_at("cart.comment", "must be \"--\", \"//\", \";;\" or \"#\"");
    origin.comment = comment.get<std::string>();
    const Json data = take(cart, "data"), lines = take(cart, "lines");
    bytes = data.is_null() ? take_lines(lines, level, origin.comment) : bytes_of_hex(data, "cart.data");
    if (bytes) content = text_content(*bytes, origin.comment);
  } else {
    return error_at("cart.kind", "must be \"tic\" or \"text\"");
  }
  if (!bytes) return tl::unexpected(bytes.error());
  if (!content) {
    const FormatError& error = content.error();
    return error_at("cart",
                    "is damaged" + (error.place.empty() ? "" : " at " + error.place) + ": " + error.message);
  }
  origin.bytes = *std::move(bytes);
  return std::make_shared<const CartOrigin>(std::move(origin));
}

}  // namespace talus
