// Reads sections of comment lines, and writes them without touching the others.
#include "tic_text.h"

#include <algorithm>
#include <array>
#include <optional>

#include "../text/hex.h"
#include "tic_cart.h"

namespace talus {
namespace {

struct Language {
  std::string_view extension;
  std::string_view comment;
};
constexpr std::array<Language, 12> kLanguages = {{{"lua", "--"},
                                                  {"yue", "--"},
                                                  {"moon", "--"},
                                                  {"wasmp", "--"},
                                                  {"js", "//"},
                                                  {"nut", "//"},
                                                  {"wren", "//"},
                                                  {"fnl", ";;"},
                                                  {"scm", ";;"},
                                                  {"rb", "#"},
                                                  {"py", "#"},
                                                  {"janet", "#"}}};
constexpr std::array<std::string_view, 4> kComments = {"--", "//", ";;", "#"};
constexpr SectionInfo kLang = {Section::tiles, "LANG", kTicLang, 1, 1};  // its id means nothing

std::string tag_start(std::string_view comment) { return std::string(comment) + " <"; }

std::string_view without_trailing_space(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" \t\r");
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

std::size_t line_end(std::string_view bytes, std::size_t at) {
  return std::min(bytes.find('\n', at), bytes.size());
}
std::size_t next_line(std::string_view bytes, std::size_t at) {
  return std::min(line_end(bytes, at) + 1, bytes.size());
}
std::string_view line_at(std::string_view bytes, std::size_t at) {
  return without_trailing_space(bytes.substr(at, line_end(bytes, at) - at));
}

// Returns the section that a tag such as "MAP" or "MAP3" names; nothing for an unknown tag.
std::optional<TextSection> section_of_tag(std::string_view tag) {
  TextSection section;
  section.tag = tag;
  if (tag == kLang.tag) return section;
  if (!tag.empty() && tag.back() >= '1' && tag.back() < '0' + kBankCount) {
    section.bank = tag.back() - '0';
    tag.remove_suffix(1);
  }
  for (const SectionInfo& info : section_infos()) {
    if (info.tag == tag) {
      section.info = &info;
      return section;
    }
  }
  return std::nullopt;
}

// Returns the tag of an opening line "-- <MAP>"; empty for any other line.
std::string_view tag_of_line(std::string_view line, std::string_view start) {
  if (!line.starts_with(start) || !line.ends_with('>')) return {};
  return line.substr(start.size(), line.size() - start.size() - 1);
}

// Finds the extent of a section that opens at `begin`.
FormatResult<void> locate(std::string_view bytes, std::string_view comment, TextSection& section) {
  const std::string open = tag_start(comment) + section.tag + ">";
  const std::size_t first = bytes.find(open);
  if (first != section.begin) {
    return error_at_line(
        bytes, first,
        "\"" + open + "\" stands before its section, but TIC-80 would read the section from here");
  }
  const std::size_t opened = line_end(bytes, section.begin);
  const std::size_t close = bytes.find("\n" + std::string(comment) + " </" + section.tag + ">", opened);
  if (close == std::string_view::npos)
    return error_at_line(bytes, section.begin, "the section " + section.tag + " has no end");
  section.rows = next_line(bytes, section.begin);
  section.rows_end = close + 1;
  section.end = next_line(bytes, section.rows_end);
  if (section.end < bytes.size() && line_at(bytes, section.end).empty())
    section.end = next_line(bytes, section.end);
  return {};
}

// Reads one row "-- 012:00ff.." into data. Rows of the palette have the high digit first, the others the low
// one.
FormatResult<void> read_row(std::string_view bytes, std::size_t offset, std::string_view comment,
                            const SectionInfo& info, std::string& data) {
  std::string_view line = line_at(bytes, offset);
  const std::string head = std::string(comment) + " ";
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool has_head = line.size() >= head.size() + 4 && line.starts_with(head) &&
                        line[head.size() + 3] == ':' &&
                        std::all_of(&line[head.size()], &line[head.size() + 3], is_digit);
  if (!has_head) return error_at_line(bytes, offset, "this is not a row of " + std::string(info.tag));
  const int row = std::stoi(std::string(line.substr(head.size(), 3)));
  if (row >= info.rows) {
    return error_at_line(bytes, offset,
                         std::string(info.tag) + " must have rows 0 to " + std::to_string(info.rows - 1));
  }
  line.remove_prefix(head.size() + 4);
  if (line.size() != 2 * static_cast<std::size_t>(info.row_bytes)) {
    return error_at_line(bytes, offset,
                         "a row of " + std::string(info.tag) + " has " + std::to_string(2 * info.row_bytes) +
                             " digits, but this one has " + std::to_string(line.size()));
  }
  for (int i = 0; i < info.row_bytes; ++i) {
    int high = hex_value(line[2 * i]), low = hex_value(line[2 * i + 1]);
    if (high < 0 || low < 0)
      return error_at_line(bytes, offset, "this row has a character that is not a hexadecimal digit");
    if (info.id != Section::palette) std::swap(high, low);
    data[static_cast<std::size_t>(row) * info.row_bytes + i] = static_cast<char>(high << 4 | low);
  }
  return {};
}

FormatResult<std::string> read_rows(std::string_view bytes, std::string_view comment,
                                    const TextSection& section) {
  const SectionInfo& info = section.info ? *section.info : kLang;
  std::string data(info.size(), '\0');
  for (std::size_t at = section.rows; at < section.rows_end; at = next_line(bytes, at)) {
    if (line_at(bytes, at).empty()) continue;
    if (const auto row = read_row(bytes, at, comment, info, data); !row) return tl::unexpected(row.error());
  }
  trim_zeros(data);
  return data;
}

// A whole section with the empty line behind it. A section of zeros gives nothing, unless its tags are
// needed.
std::string render_section(const SectionInfo& info, int bank, std::string_view data, std::string_view comment,
                           std::string_view newline, bool keep_tags = false) {
  const std::string rows = text_rows(info, data, comment, newline);
  if (rows.empty() && !keep_tags) return {};
  const std::string tag = std::string(info.tag) + (bank == 0 ? "" : std::to_string(bank)) + ">";
  const std::string prefix(comment), end(newline);
  return prefix + " <" + tag + end + rows + prefix + " </" + tag + end + end;
}

std::string render_text(const CartContent& cart, std::string_view comment) {
  std::string sections;
  for (const SectionInfo& info : section_infos()) {
    for (int bank = 0; bank < kBankCount; ++bank) {
      sections += render_section(info, bank, at(cart.banks[bank], info.id), comment, "\n");
    }
  }
  const std::string lang(1, static_cast<char>(cart.lang));
  sections += render_section(kLang, 0, lang, comment, "\n");
  return cart.code + (cart.code.empty() || sections.empty() ? "" : "\n") + sections;
}

// A reader could take code for the start of a section, so the result is read once more.
FormatResult<void> check_reads_back(std::string_view bytes, std::string_view comment,
                                    const CartContent& cart) {
  const auto again = text_content(bytes, comment);
  if (again && again->code == cart.code && again->banks == cart.banks) return {};
  return tl::unexpected(
      FormatError{"", "the code holds text that a text project would take for a section, such as \"" +
                          tag_start(comment) + "\" at the start of a line"});
}

// The order in which TIC-80 writes sections.
int rank_of(const TextSection& section) {
  if (!section.info) return kSectionCount * kBankCount;
  return static_cast<int>(section.info->id) * kBankCount + section.bank;
}

struct Edit {
  std::size_t begin = 0, end = 0;  // what to replace; equal for an insertion
  std::string text;
};

Edit edit_of(const TextProject& project, std::size_t size, const SectionInfo& info, std::string text) {
  const int rank = static_cast<int>(info.id) * kBankCount;
  for (const TextSection& section : project.sections) {
    if (rank_of(section) == rank) return {section.begin, section.end, std::move(text)};
  }
  for (const TextSection& section : project.sections) {
    if (rank_of(section) > rank) return {section.begin, section.begin, std::move(text)};
  }
  const std::size_t end = project.sections.empty() ? size : project.sections.back().end;
  return {end, end, std::move(text)};
}

// edits: in the order of the sections; those of one place stay in that order.
std::string apply(std::string_view bytes, std::vector<Edit> edits, std::string_view newline, bool code_only) {
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string out;
  std::size_t done = 0;
  for (const Edit& edit : edits) {
    out += bytes.substr(done, edit.begin - done);
    const bool cut_line = !out.empty() && out.back() != '\n';
    if (cut_line || (code_only && !out.empty())) out += newline;
    code_only = false;
    out += edit.text;
    done = edit.end;
  }
  out += bytes.substr(done);
  return out;
}

std::string_view sniff_comment(std::string_view bytes, const FormatContext& context) {
  const std::string_view known = comment_of_extension(context.extension);
  for (const std::string_view comment : kComments) {
    if (!known.empty() && comment != known) continue;
    const std::string start = tag_start(comment);
    for (std::size_t at = bytes.starts_with(start) ? 0 : bytes.find("\n" + start); at < bytes.size();
         at = bytes.find("\n" + start, at + 1)) {
      const std::size_t line = bytes[at] == '\n' ? at + 1 : at;
      if (section_of_tag(tag_of_line(line_at(bytes, line), start))) return comment;
    }
  }
  return {};
}

}  // namespace

std::string_view comment_of_extension(std::string_view extension) {
  for (const Language& language : kLanguages) {
    if (language.extension == extension) return language.comment;
  }
  return {};
}

std::span<const std::string_view> text_extensions() {
  static const auto extensions = [] {
    std::array<std::string_view, kLanguages.size()> list;
    std::transform(kLanguages.begin(), kLanguages.end(), list.begin(),
                   [](const Language& l) { return l.extension; });
    return list;
  }();
  return extensions;
}

FormatResult<TextProject> parse_text(std::string_view bytes, std::string_view comment) {
  if (bytes.size() > kMaxCartBytes)
    return tl::unexpected(FormatError{"", "is larger than 4 MiB, the limit for carts"});
  if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos) {
    return error_at_line(bytes, nul, "a text project must not have NUL bytes");
  }
  TextProject project;
  const std::string start = tag_start(comment);
  const std::size_t code_end =
      bytes.starts_with(start) ? 0 : std::min(bytes.find("\n" + start), bytes.size());
  project.code = bytes.substr(0, code_end);
  for (std::size_t at = code_end == 0 ? 0 : std::min(code_end + 1, bytes.size()); at < bytes.size();) {
    const std::string_view line = line_at(bytes, at);
    auto section = section_of_tag(tag_of_line(line, start));
    const auto same = [&](const TextSection& other) { return other.tag == section->tag; };
    if (!section || std::any_of(project.sections.begin(), project.sections.end(), same)) {
      project.strays += line.empty() ? 0 : 1;
      at = next_line(bytes, at);
      continue;
    }
    section->begin = at;
    if (const auto found = locate(bytes, comment, *section); !found) return tl::unexpected(found.error());
    at = section->end;
    project.sections.push_back(*std::move(section));
  }
  return project;
}

FormatResult<CartContent> text_content(std::string_view bytes, std::string_view comment) {
  const auto project = parse_text(bytes, comment);
  if (!project) return tl::unexpected(project.error());
  CartContent cart;
  cart.code = project->code;
  std::erase(cart.code, '\r');
  for (const TextSection& section : project->sections) {
    auto data = read_rows(bytes, comment, section);
    if (!data) return tl::unexpected(data.error());
    if (section.info) {
      at(cart.banks[section.bank], section.info->id) = *std::move(data);
    } else {
      cart.lang = data->empty() ? 0 : static_cast<std::uint8_t>(data->front());
    }
  }
  if (project->strays > 0) {
    cart.rest.push_back(std::to_string(project->strays) + " lines that are neither code nor a known section");
  }
  return cart;
}

std::string text_rows(const SectionInfo& info, std::string_view data, std::string_view comment,
                      std::string_view newline) {
  std::string text;
  for (int row = 0; row < info.rows; ++row) {
    const std::size_t begin = static_cast<std::size_t>(row) * info.row_bytes;
    if (begin >= data.size()) break;
    std::string bytes(data.substr(begin, info.row_bytes));
    if (bytes.find_first_not_of('\0') == std::string::npos) continue;
    bytes.resize(info.row_bytes);
    std::string hex = to_hex(bytes);
    if (info.id != Section::palette) {
      for (std::size_t i = 0; i < hex.size(); i += 2) std::swap(hex[i], hex[i + 1]);
    }
    const std::string number = std::to_string(row);
    text.append(comment).append(" ").append(3 - number.size(), '0').append(number).append(":");
    text.append(hex).append(newline);
  }
  return text;
}

FormatResult<std::string> edited_text(const CartOrigin& origin, const Level& level) {
  const std::string_view bytes = origin.bytes;
  const auto project = parse_text(bytes, origin.comment);
  if (!project) return tl::unexpected(project.error());
  auto cart = text_content(bytes, origin.comment);
  if (!cart) return tl::unexpected(cart.error());
  const Bank before = cart->banks[0];
  cart->banks[0] = edited_bank(level, before);
  const std::string_view newline = bytes.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
  // The first section ends the code: without its tags, stray lines behind it would become code.
  const bool keep_tags = project->strays > 0;
  std::vector<Edit> edits;
  for (const Section id : kLevelSections) {
    const std::string& data = at(cart->banks[0], id);
    if (data == at(before, id)) continue;
    const SectionInfo& info = section_info(id);
    std::string text = render_section(info, 0, data, origin.comment, newline, keep_tags);
    edits.push_back(edit_of(*project, bytes.size(), info, std::move(text)));
  }
  if (edits.empty()) return std::string(bytes);
  const bool code_only = project->sections.empty() && project->strays == 0;
  std::string edited = apply(bytes, std::move(edits), newline, code_only);
  const auto after = parse_text(edited, origin.comment);
  // Without a section behind it, the line break that ends the code would become part of it.
  if (after && after->sections.empty() && after->strays == 0) edited = project->code;
  if (const auto good = check_reads_back(edited, origin.comment, *cart); !good)
    return tl::unexpected(good.error());
  return edited;
}

bool accepts_text(std::string_view bytes, const FormatContext& context) {
  return !sniff_comment(bytes, context).empty();
}

FormatResult<Level> read_text(std::string_view bytes, const FormatContext& context) {
  std::string_view comment = comment_of_extension(context.extension);
  if (comment.empty()) comment = sniff_comment(bytes, context);
  if (comment.empty()) comment = kComments[0];
  auto cart = text_content(bytes, comment);
  if (!cart) return tl::unexpected(cart.error());
  Level level = level_of_bank(cart->banks[0]);
  level.cart = std::make_shared<CartOrigin>(
      CartOrigin{CartOrigin::Kind::text, std::string(comment), std::string(bytes)});
  return level;
}

FormatResult<WrittenLevel> write_text(const Level& level, const FormatContext& context) {
  if (const auto good = check_fits_cart(level); !good) return tl::unexpected(good.error());
  std::vector<std::string> dropped;
  const CartOrigin* origin = level.cart.get();
  const bool from_text = origin && origin->kind == CartOrigin::Kind::text;
  std::string_view comment = comment_of_extension(context.extension);
  if (comment.empty()) comment = from_text ? std::string_view(origin->comment) : kComments[0];
  if (from_text && origin->comment == comment) {
    auto bytes = edited_text(*origin, level);
    if (!bytes) return tl::unexpected(bytes.error());
    return WrittenLevel{*std::move(bytes), {}};
  }
  auto cart = !origin     ? new_cart()
              : from_text ? text_content(origin->bytes, origin->comment)
                          : tic_content(origin->bytes);
  if (!cart) return tl::unexpected(cart.error());
  dropped.insert(dropped.end(), cart->rest.begin(), cart->rest.end());
  if (std::erase(cart->code, '\r') > 0) dropped.emplace_back("the carriage returns of the code");
  cart->banks[0] = edited_bank(level, cart->banks[0]);
  std::string bytes = render_text(*cart, comment);
  if (const auto good = check_reads_back(bytes, comment, *cart); !good) return tl::unexpected(good.error());
  return WrittenLevel{std::move(bytes), std::move(dropped)};
}

}  // namespace talus
