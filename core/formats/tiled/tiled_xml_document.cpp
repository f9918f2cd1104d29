// TMX and TSX.
#include <algorithm>
#include <charconv>
#include <pugixml.hpp>

#include "../text/append_number.h"
#include "../text/xml_places.h"
#include "tiled_cells.h"
#include "tiled_document.h"
#include "tiled_map.h"
#include "tiled_xml_editor.h"

namespace talus {
namespace {

// Where the cells of a block are.
struct XmlCells {
  pugi::xml_node element;  // "data" or "chunk"
  TiledEncoding how;
  std::string_view value() const { return element.child_value(); }
  std::vector<pugi::xml_node> tiles() const {
    const auto range = element.children("tile");
    return {range.begin(), range.end()};
  }
};

std::uint32_t number_of_tile(const pugi::xml_node& tile) { return tile.attribute("gid").as_uint(); }

class TiledXmlDocument : public TiledDocument {
 public:
  explicit TiledXmlDocument(std::string_view text) : text_(text), places_(text) {}

  bool read() {
    constexpr unsigned kParts = pugi::parse_default | pugi::parse_fragment;  // as tiled_xml.cpp
    if (!document_.load_buffer(text_.data(), text_.size(), kParts, pugi::encoding_utf8)) return false;
    root_ = document_.document_element();
    find_layers(root_);
    return true;
  }

  int layer_count() const override { return static_cast<int>(layers_.size()); }
  FormatResult<std::vector<TiledBlock>> blocks(int layer) const override;
  void put_cells(int layer, std::size_t block, const TiledBlock& content) override;
  void add_chunks(int layer, const std::vector<TiledBlock>& chunks) override;
  void set_looks(int layer, const TileLayer& before, const TileLayer& now) override;
  void set_size(int width, int height) override;
  void edit_tiles(int tileset, const TiledTileEdits& edits) override;
  std::string text() const override { return edits_.applied_to(text_); }

 private:
  void find_layers(const pugi::xml_node& node);
  std::vector<XmlCells> cells_of(int layer) const;
  FormatResult<std::vector<std::uint32_t>> read_cells(const XmlCells& at, std::size_t count) const;
  void put_tiles(const XmlCells& at, const TiledBlock& content);
  std::string new_content(const XmlCells& like, const TiledBlock& content) const;

  std::string_view text_;
  XmlPlaces places_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::vector<pugi::xml_node> layers_;  // tile layers
  TextEdits edits_;
};

// Groups are at most as deep as the reader allows.
void TiledXmlDocument::find_layers(const pugi::xml_node& node) {
  for (const pugi::xml_node child : node.children()) {
    const std::string_view name = child.name();
    if (name == "layer")
      layers_.push_back(child);
    else if (name == "group")
      find_layers(child);
  }
}

std::vector<XmlCells> TiledXmlDocument::cells_of(int layer) const {
  std::vector<XmlCells> all;
  const pugi::xml_node data = layers_[static_cast<std::size_t>(layer)].child("data");
  if (!data) return all;
  const TiledEncoding how{data.attribute("encoding").value(), data.attribute("compression").value()};
  for (const pugi::xml_node chunk : data.children("chunk")) all.push_back({chunk, how});
  if (all.empty()) all.push_back({data, how});
  return all;
}

FormatResult<std::vector<TiledBlock>> TiledXmlDocument::blocks(int layer) const {
  std::vector<TiledBlock> all;
  const pugi::xml_node node = layers_[static_cast<std::size_t>(layer)];
  for (const XmlCells& at : cells_of(layer)) {
    TiledBlock block;
    block.is_chunk = root_.attribute("infinite").as_int() != 0;
    const bool has_own = at.element.attribute("width");
    const pugi::xml_node sized = has_own ? at.element : node.attribute("width") ? node : root_;
    block.width = sized.attribute("width").as_int();
    block.height = sized.attribute("height").as_int();
    if (block.is_chunk) {
      block.x = sized.attribute("x").as_int();
      block.y = sized.attribute("y").as_int();
    }
    const bool is_blank = at.value().find_first_not_of(" \t\r\n") == std::string_view::npos;
    if (block.is_chunk && !has_own && is_blank && at.tiles().empty()) continue;  // it has no chunk yet
    auto cells = read_cells(at, static_cast<std::size_t>(std::max(block.width, 0)) *
                                    static_cast<std::size_t>(std::max(block.height, 0)));
    if (!cells) return tl::unexpected(cells.error());
    block.cells = *std::move(cells);
    all.push_back(std::move(block));
  }
  return all;
}

FormatResult<std::vector<std::uint32_t>> TiledXmlDocument::read_cells(const XmlCells& at,
                                                                      std::size_t count) const {
  std::vector<std::uint32_t> cells;
  if (at.how.encoding.empty()) {
    for (const pugi::xml_node& tile : at.tiles()) cells.push_back(number_of_tile(tile));
  } else if (at.value().find_first_not_of(" \t\r\n") != std::string_view::npos) {
    auto decoded = decode_tiled_cells(at.value(), at.how.encoding, at.how.compression, count);
    if (!decoded) return tl::unexpected(FormatError{"", "has a layer that " + decoded.error()});
    return *std::move(decoded);
  }
  if (cells.empty()) cells.assign(count, 0);
  if (cells.size() != count)
    return tl::unexpected(FormatError{"", "has a layer that " + tiled_count_problem(cells.size(), count)});
  return cells;
}

void TiledXmlDocument::put_cells(int layer, std::size_t block, const TiledBlock& content) {
  const XmlCells at = cells_of(layer)[block];
  if (at.how.encoding.empty() && !at.tiles().empty()) return put_tiles(at, content);
  const TextSpan inside = places_.inside(at.element);
  if (!places_.has_inside(at.element))
    return append_xml_inside(places_, at.element, new_content(at, content), edits_);
  std::string_view old = inside.in(text_);
  // A value with references or comments is written anew.
  if (old.find_first_of("<&") != old.npos) old = at.value();
  edits_.replace(inside, at.how.encoding.empty() ? new_content(at, content)
                                                 : recode_tiled_cells(old, at.how, content.cells,
                                                                      content.width, line_end_of(text_)));
}

// Cells that are elements.
void TiledXmlDocument::put_tiles(const XmlCells& at, const TiledBlock& content) {
  const std::vector<pugi::xml_node> tiles = at.tiles();
  if (tiles.size() != content.cells.size())
    return edits_.replace(places_.inside(at.element), new_content(at, content));
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (number_of_tile(tiles[i]) != content.cells[i])
      set_xml_attribute(places_, tiles[i], "gid", std::to_string(content.cells[i]), edits_);
  }
}

// like: the element that has or gets the content, or one beside it.
std::string TiledXmlDocument::new_content(const XmlCells& like, const TiledBlock& content) const {
  const std::string outer = places_.break_before(like.element);
  if (like.how.encoding == "csv")
    return recode_tiled_cells("", like.how, content.cells, content.width, line_end_of(text_));
  if (like.how.encoding == "base64") {
    const std::string inner = outer.empty() ? "" : outer + " ";
    return inner + recode_tiled_cells("", like.how, content.cells, content.width, line_end_of(text_)) + outer;
  }
  std::string tiles;
  for (const std::uint32_t cell : content.cells)
    tiles += (outer.empty() ? "" : outer + " ") + "<tile gid=\"" + std::to_string(cell) + "\"/>";
  return tiles + outer;
}

void TiledXmlDocument::add_chunks(int layer, const std::vector<TiledBlock>& chunks) {
  const pugi::xml_node data = layers_[static_cast<std::size_t>(layer)].child("data");
  const XmlCells like = cells_of(layer).back();
  const bool has_chunks = like.element != data;
  const std::string data_break = places_.break_before(data);
  const std::string chunk_break = has_chunks           ? places_.break_before(like.element)
                                  : data_break.empty() ? ""
                                                       : data_break + " ";
  const auto number = [](const char* name, int value) {
    return " " + std::string(name) + "=\"" + std::to_string(value) + "\"";
  };
  std::string text;
  for (const TiledBlock& chunk : chunks) {
    text += chunk_break + "<chunk" + number("x", chunk.x) + number("y", chunk.y) +
            number("width", chunk.width) + number("height", chunk.height) + ">" + new_content(like, chunk) +
            "</chunk>";
  }
  if (has_chunks) return edits_.insert(places_.whole(like.element).end, text);
  if (places_.has_inside(data)) return edits_.replace(places_.inside(data), text + data_break);
  append_xml_inside(places_, data, text + data_break, edits_);
}

void TiledXmlDocument::set_looks(int layer, const TileLayer& before, const TileLayer& now) {
  const pugi::xml_node node = layers_[static_cast<std::size_t>(layer)];
  const auto set = [&](const char* name, const std::string& value) {
    set_xml_attribute(places_, node, name, value, edits_);
  };
  const auto set_number = [&](const char* name, double value) {
    std::string text;
    append_number(text, value);
    set(name, text);
  };
  const auto own = [&](const char* name, double usual) { return node.attribute(name).as_double(usual); };
  if (before.name != now.name) set("name", now.name);
  if (before.visible != now.visible) set("visible", now.visible ? "1" : "0");
  if (before.locked != now.locked) set("locked", now.locked ? "1" : "0");
  if (before.opacity != now.opacity) set_number("opacity", now.opacity);
  if (before.tint != now.tint) set("tintcolor", tiled_color(now.tint));
  if (before.offset.x != now.offset.x)
    set_number("offsetx", own("offsetx", 0) + now.offset.x - before.offset.x);
  if (before.offset.y != now.offset.y)
    set_number("offsety", own("offsety", 0) + now.offset.y - before.offset.y);
  if (before.parallax.x != now.parallax.x) set_number("parallaxx", now.parallax.x);
  if (before.parallax.y != now.parallax.y) set_number("parallaxy", now.parallax.y);
  if (before.is_ground != now.is_ground)
    TiledXmlEditor(text_, places_, root_, edits_).set_property(node, {"ground", now.is_ground});
}

void TiledXmlDocument::set_size(int width, int height) {
  std::vector<pugi::xml_node> sized = layers_;
  sized.push_back(root_);
  for (const pugi::xml_node& node : sized) {
    if (node != root_ && !node.attribute("width")) continue;
    set_xml_attribute(places_, node, "width", std::to_string(width), edits_);
    set_xml_attribute(places_, node, "height", std::to_string(height), edits_);
  }
}

void TiledXmlDocument::edit_tiles(int tileset, const TiledTileEdits& edits) {
  pugi::xml_node node = root_;
  if (std::string_view(root_.name()) == "map") {
    node = root_.child("tileset");
    for (int i = 0; i < tileset && node; ++i) node = node.next_sibling("tileset");
  }
  if (node) TiledXmlEditor(text_, places_, root_, edits_).edit_tiles(node, edits);
}

}  // namespace

FormatResult<std::unique_ptr<TiledDocument>> tiled_xml_document(std::string_view bytes) {
  auto document = std::make_unique<TiledXmlDocument>(bytes);
  if (!document->read()) return tl::unexpected(FormatError{"", "is not valid XML"});
  return document;
}

}  // namespace talus
