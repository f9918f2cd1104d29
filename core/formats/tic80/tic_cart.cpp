// Reads and writes chunks. The reader goes over the chunks twice, palettes first, as TIC-80 does: a WAVEFORM
// chunk wins over a DEFAULT chunk wherever it stands.
#include "tic_cart.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "../text/unpack.h"
#include "tic_text.h"

namespace talus {
namespace {

constexpr std::size_t kHeaderBytes = 4;

tl::unexpected<FormatError> error_at(std::size_t offset, std::string message) {
  return tl::unexpected(FormatError{"byte " + std::to_string(offset), std::move(message)});
}

bool is_piece(int type) { return type == kTicCode || type == kTicBinary; }

std::string name_or_number(int type) {
  const std::string_view name = tic_chunk_name(type);
  return name.empty() ? "type " + std::to_string(type) : std::string(name);
}

// Whether it has more than the empty chunks of type 0 as which a file of zero bytes is read.
bool has_any_chunk(const std::vector<TicChunk>& chunks) {
  return std::any_of(chunks.begin(), chunks.end(),
                     [](const TicChunk& chunk) { return chunk.type != 0 || !chunk.data.empty(); });
}

// The section that a chunk holds; null for code, DEFAULT, and chunks that are kept unread.
const SectionInfo* section_of(const TicChunk& chunk) {
  for (const SectionInfo& info : section_infos()) {
    if (info.chunk == chunk.type) return &info;
  }
  return nullptr;
}

// TIC-80 copies a chunk over the bytes of an earlier one; those behind a shorter chunk stay.
void overlay(std::string& section, std::string_view data) {
  if (section.size() < data.size()) section.resize(data.size());
  section.replace(0, data.size(), data);
  trim_zeros(section);
}

// Of several compressed codes the last one counts, as TIC-80 unpacks each over the one before. Only that one
// is unpacked: a cart may have thousands. Returns an empty code if there is none.
FormatResult<std::string> unpack_code(const std::vector<TicChunk>& chunks) {
  const auto last = std::find_if(chunks.rbegin(), chunks.rend(),
                                 [](const TicChunk& chunk) { return chunk.type == kTicCodeZip; });
  if (last == chunks.rend()) return std::string();
  const TicChunk& chunk = *last;
  auto code = unpack_zlib(chunk.data, kCodeLimit);
  if (code) return *std::move(code);
  if (code.error().is_too_large)
    return error_at(chunk.offset, "the compressed code unpacks to more than 524287 bytes");
  return error_at(chunk.offset, "the compressed code is damaged");
}

// Pieces of code from the highest bank down; of two for one bank, the later one.
std::string join_code(const std::vector<TicChunk>& chunks) {
  std::array<std::string_view, kBankCount> pieces;
  for (const TicChunk& chunk : chunks) {
    if (chunk.type == kTicCode) pieces[chunk.bank] = chunk.data;
  }
  std::string code;
  for (int bank = kBankCount - 1; bank >= 0; --bank) code += pieces[bank];
  return code;
}

// TIC-80 holds code as a C string, so a NUL ends it.
void set_code(CartContent& cart, std::string code) {
  const std::size_t end = std::min(code.find('\0'), code.size());
  if (code.find_first_not_of('\0', end) != std::string::npos) cart.rest.emplace_back("code after a NUL byte");
  code.resize(end);
  cart.code = std::move(code);
}

void list_rest(const std::vector<TicChunk>& chunks, CartContent& cart) {
  for (const TicChunk& chunk : chunks) {
    const bool carried = section_of(chunk) || chunk.type == kTicCode || chunk.type == kTicCodeZip ||
                         chunk.type == kTicDefault || chunk.type == kTicLang;
    if (carried) continue;
    cart.rest.push_back("the " + name_or_number(chunk.type) + " chunk of bank " + std::to_string(chunk.bank));
  }
}

// Order in which TIC-80 writes chunks: by bank and then in this order, BINARY and code last. -1: it never
// writes them.
int canonical_rank(int type, int bank) {
  constexpr std::array kOrder = {17, 12, 10, 1, 2, 4, 9, 15, 14, 6, 18};
  if (type == kTicBinary) return 1000;
  if (type == kTicCode || type == kTicCodeZip) return 1001;
  const auto found = std::find(kOrder.begin(), kOrder.end(), type);
  return found == kOrder.end() ? -1 : 100 * bank + static_cast<int>(found - kOrder.begin());
}

void insert_canonically(std::vector<TicChunk>& chunks, const TicChunk& added) {
  const int rank = canonical_rank(added.type, added.bank);
  const auto place = std::find_if(chunks.begin(), chunks.end(), [&](const TicChunk& chunk) {
    return canonical_rank(chunk.type, chunk.bank) > rank;
  });
  chunks.insert(place, added);
}

// Replaces the first chunk of this section in bank 0 with `data`, and removes the others.
void replace_section(std::vector<TicChunk>& chunks, const SectionInfo& info, std::string_view data) {
  const auto is_old = [&](const TicChunk& chunk) { return chunk.type == info.chunk && chunk.bank == 0; };
  auto rest = std::find_if(chunks.begin(), chunks.end(), is_old);
  if (rest != chunks.end() && !data.empty()) {
    *rest++ = {.type = info.chunk, .data = data};
  } else if (!data.empty()) {
    return insert_canonically(chunks, {.type = info.chunk, .data = data});
  }
  chunks.erase(std::remove_if(rest, chunks.end(), is_old), chunks.end());
}

std::string join(const std::vector<TicChunk>& chunks) {
  std::string bytes;
  for (const TicChunk& chunk : chunks) append_tic_chunk(bytes, chunk);
  return bytes;
}

bool is_default(const Bank& bank) {
  return at(bank, Section::palette) == default_palette_bytes() &&
         at(bank, Section::waves) == default_wave_bytes();
}

void add_code(std::vector<TicChunk>& chunks, std::string_view code) {
  for (int bank = static_cast<int>(code.size() / kBankBytes); bank >= 0; --bank) {
    const std::string_view piece = code.substr(0, kBankBytes);
    if (!piece.empty()) chunks.push_back({.type = kTicCode, .bank = bank, .data = piece});
    code.remove_prefix(piece.size());
  }
}

// The bytes of a cartridge with the level in it. Adds to `dropped` what only a text project could hold.
FormatResult<std::string> tic_of(const Level& level, std::vector<std::string>& dropped) {
  if (level.cart && level.cart->kind == CartOrigin::Kind::tic) return edited_tic(level.cart->bytes, level);
  auto cart = level.cart ? text_content(level.cart->bytes, level.cart->comment) : new_cart();
  if (!cart) return tl::unexpected(cart.error());
  if (cart->code.size() > kCodeLimit) {
    return tl::unexpected(FormatError{"", "the code has " + std::to_string(cart->code.size()) +
                                              " bytes, but a cartridge holds at most 524287"});
  }
  dropped.insert(dropped.end(), cart->rest.begin(), cart->rest.end());
  if (cart->lang != 0) dropped.emplace_back("the LANG section (TIC-80 never writes it to a cartridge)");
  cart->banks[0] = edited_bank(level, cart->banks[0]);
  return tic_bytes(*cart);
}

}  // namespace

std::string_view tic_chunk_name(int type) {
  constexpr std::array<std::string_view, 21> kNames = {
      "",      "TILES",    "SPRITES",  "COVER",    "MAP",    "CODE",    "FLAGS",
      "",      "",         "SAMPLES",  "WAVEFORM", "",       "PALETTE", "PATTERNS_OLD",
      "MUSIC", "PATTERNS", "CODE_ZIP", "DEFAULT",  "SCREEN", "BINARY",  "LANG"};
  return type >= 0 && type < static_cast<int>(kNames.size()) ? kNames[type] : std::string_view();
}

FormatResult<std::vector<TicChunk>> parse_tic(std::string_view bytes) {
  if (bytes.empty()) return tl::unexpected(FormatError{"", "the file is empty"});
  if (bytes.size() > kMaxCartBytes)
    return tl::unexpected(FormatError{"", "is larger than 4 MiB, the limit for carts"});
  std::vector<TicChunk> chunks;
  for (std::size_t offset = 0; offset < bytes.size();) {
    if (bytes.size() - offset < kHeaderBytes)
      return error_at(offset, "the file ends inside a chunk's header");
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[offset + i]); };
    TicChunk chunk = {.type = byte(0) & 31, .bank = byte(0) >> 5, .reserved = byte(3), .offset = offset};
    std::size_t size = byte(1) | static_cast<std::size_t>(byte(2)) << 8;
    if (size == 0 && is_piece(chunk.type)) size = kBankBytes;
    const std::size_t left = bytes.size() - offset - kHeaderBytes;
    if (size > left) {
      return error_at(offset, "the " + name_or_number(chunk.type) + " chunk says " + std::to_string(size) +
                                  " bytes, but the file ends after " + std::to_string(left));
    }
    chunk.data = bytes.substr(offset + kHeaderBytes, size);
    const SectionInfo* info = section_of(chunk);
    if (info && size > info->size()) {
      return error_at(offset, "the " + name_or_number(chunk.type) + " chunk has " + std::to_string(size) +
                                  " bytes, more than the " + std::to_string(info->size()) + " it can have");
    }
    chunks.push_back(chunk);
    offset += kHeaderBytes + size;
  }
  return chunks;
}

void append_tic_chunk(std::string& out, const TicChunk& chunk) {
  const std::size_t size = chunk.data.size();
  assert(size < kBankBytes || (size == kBankBytes && is_piece(chunk.type)));
  out += static_cast<char>(chunk.type | chunk.bank << 5);
  out += static_cast<char>(size & 255);
  out += static_cast<char>(size >> 8 & 255);
  out += static_cast<char>(chunk.reserved);
  out += chunk.data;
}

FormatResult<CartContent> tic_content(std::string_view bytes, const Progress& progress) {
  const auto chunks = parse_tic(bytes);
  if (!chunks) return tl::unexpected(chunks.error());
  if (!has_any_chunk(*chunks))
    return tl::unexpected(FormatError{"", "has no chunk that TIC-80 loads: the file is damaged"});
  CartContent cart;
  for (const TicChunk& chunk : *chunks) {
    Bank& bank = cart.banks[chunk.bank];
    if (chunk.type == kTicDefault) {
      overlay(at(bank, Section::palette), default_palette_bytes());
      overlay(at(bank, Section::waves), default_wave_bytes());
    } else if (chunk.type == section_info(Section::palette).chunk) {
      overlay(at(bank, Section::palette), chunk.data);
    }
  }
  std::size_t read = 0;
  for (const TicChunk& chunk : *chunks) {
    if (!progress.at(read++, chunks->size())) return was_cancelled();
    const SectionInfo* info = section_of(chunk);
    if (info && info->id != Section::palette) overlay(at(cart.banks[chunk.bank], info->id), chunk.data);
    if (chunk.type == kTicLang && !chunk.data.empty()) cart.lang = static_cast<std::uint8_t>(chunk.data[0]);
  }
  auto unpacked = unpack_code(*chunks);
  if (!unpacked) return tl::unexpected(unpacked.error());
  const bool packed = !unpacked->empty() && unpacked->front() != '\0';
  set_code(cart, packed ? *std::move(unpacked) : join_code(*chunks));
  list_rest(*chunks, cart);
  return cart;
}

std::string tic_bytes(const CartContent& cart) {
  std::vector<TicChunk> chunks;
  for (int bank = 0; bank < kBankCount; ++bank) {
    const Bank& content = cart.banks[bank];
    const bool defaults = is_default(content);
    if (defaults) chunks.push_back({.type = kTicDefault, .bank = bank});
    for (const SectionInfo& info : section_infos()) {
      const std::string& data = at(content, info.id);
      const bool in_default = defaults && (info.id == Section::palette || info.id == Section::waves);
      if (!data.empty() && !in_default) chunks.push_back({.type = info.chunk, .bank = bank, .data = data});
    }
  }
  std::stable_sort(chunks.begin(), chunks.end(), [](const TicChunk& a, const TicChunk& b) {
    return canonical_rank(a.type, a.bank) < canonical_rank(b.type, b.bank);
  });
  add_code(chunks, cart.code);
  return join(chunks);
}

FormatResult<std::string> edited_tic(std::string_view bytes, const Level& level) {
  auto chunks = parse_tic(bytes);
  if (!chunks) return tl::unexpected(chunks.error());
  const auto cart = tic_content(bytes);
  if (!cart) return tl::unexpected(cart.error());
  const Bank& before = cart->banks[0];
  const Bank after = edited_bank(level, before);
  for (const Section id : kLevelSections) {
    if (at(before, id) == at(after, id)) continue;
    if (id == Section::palette) {
      const auto is_default_chunk = [](const TicChunk& c) { return c.type == kTicDefault && c.bank == 0; };
      const auto gone = std::remove_if(chunks->begin(), chunks->end(), is_default_chunk);
      const bool had_default = gone != chunks->end();
      chunks->erase(gone, chunks->end());
      if (had_default) replace_section(*chunks, section_info(Section::waves), at(before, Section::waves));
    }
    replace_section(*chunks, section_info(id), at(after, id));
  }
  return join(*chunks);
}

bool accepts_tic(std::string_view bytes, const FormatContext&) {
  const auto chunks = parse_tic(bytes);
  return chunks && has_any_chunk(*chunks) &&
         std::all_of(chunks->begin(), chunks->end(), [](const TicChunk& c) { return c.reserved == 0; });
}

FormatResult<Level> read_tic(std::string_view bytes, const FormatContext& context) {
  auto cart = tic_content(bytes, context.progress);
  if (!cart) return tl::unexpected(cart.error());
  Level level = level_of_bank(cart->banks[0]);
  level.cart = std::make_shared<CartOrigin>(CartOrigin{CartOrigin::Kind::tic, "", std::string(bytes)});
  return level;
}

FormatResult<WrittenLevel> write_tic(const Level& level, const FormatContext&) {
  if (const auto good = check_fits_cart(level); !good) return tl::unexpected(good.error());
  std::vector<std::string> dropped;
  auto bytes = tic_of(level, dropped);
  if (!bytes) return tl::unexpected(bytes.error());
  if (bytes->empty()) {
    return tl::unexpected(
        FormatError{"", "has neither drawings nor code, but TIC-80 cannot load an empty cartridge"});
  }
  if (bytes->size() > kMaxCartBytes) {
    return tl::unexpected(FormatError{"", "takes " + std::to_string(bytes->size()) +
                                              " bytes as a cartridge, but may have only " +
                                              std::to_string(kMaxCartBytes)});
  }
  return WrittenLevel{*std::move(bytes), std::move(dropped)};
}

}  // namespace talus
