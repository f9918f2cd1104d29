// Maps and tilesets of Tiled as XML: TMX and TSX.
#include <algorithm>
#include <charconv>
#include <optional>
#include <pugixml.hpp>
#include <utility>

#include "../import/hex_color.h"
#include "../text/append_number.h"
#include "../text/xml_places.h"
#include "tiled_cells.h"
#include "tiled_document.h"
#include "tiled_ids.h"
#include "tiled_layer_order.h"
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

std::string xml_attribute(const char* name, std::string_view value) {
  return value.empty() ? "" : " " + std::string(name) + "=\"" + xml_attribute_text(value) + "\"";
}

class TiledXmlDocument : public TiledDocument {
 public:
  TiledXmlDocument(std::string_view bytes, std::string text)
      : bytes_(bytes), own_(std::move(text)), text_(own_.empty() ? bytes : own_), places_(text_) {}

  bool read() {
    constexpr unsigned kParts = pugi::parse_default | pugi::parse_fragment;  // as tiled_xml.cpp
    if (!document_.load_buffer(text_.data(), text_.size(), kParts, pugi::encoding_utf8)) return false;
    root_ = document_.document_element();
    tree_ = find_layers(root_);
    return true;
  }

  bool is_map() const override { return std::string_view(root_.name()) == "map"; }
  bool is_infinite() const override { return root_.attribute("infinite").as_int() != 0; }
  int layer_count() const override { return static_cast<int>(layers_.size()); }
  int object_layer_count() const override { return static_cast<int>(object_layers_.size()); }
  FormatResult<std::vector<TiledBlock>> blocks(int layer) const override;
  void put_cells(int layer, std::size_t block, const TiledBlock& content) override;
  void add_chunks(int layer, const std::vector<TiledBlock>& chunks) override;
  void set_looks(TiledLayerKind kind, int layer, const TileLayer& before, const TileLayer& now) override;
  void set_draw_order(int layer, bool by_y) override {
    set_xml_attribute(places_, object_layers_[static_cast<std::size_t>(layer)], "draworder",
                      by_y ? "topdown" : "index", edits_);
  }
  void edit_objects(int layer, const std::vector<TiledObjectEdit>& edits) override;
  TiledLayerTree layer_tree() const override { return tree_; }
  void arrange(const TiledLayerTree& tree) override { arrange_in(root_, tree, edits_); }
  void set_layer_size(int layer, int width, int height) override;
  void set_background(const std::string& color) override;
  void set_size(int width, int height) override;
  void edit_tiles(int tileset, const TiledTileEdits& edits) override;
  std::string text() const override;

 private:
  // line: the blanks before it, from the line break on.
  std::string new_layer(const TiledLayerNode& node, const std::string& line);
  std::string new_group(const TiledLayerNode& group, const std::string& line);
  void arrange_in(const pugi::xml_node& parent, const TiledLayerTree& inside, TextEdits& edits);
  // Where a layer comes that does not stay: behind an element, or before it; null: at the end of the parent.
  struct Gap {
    pugi::xml_node beside;
    bool is_before = false;
  };
  Gap first_gap(const pugi::xml_node& parent, const TiledLayerTree& inside,
                const std::vector<bool>& stays) const;
  std::string text_of(const TiledLayerNode& node, const std::string& line);
  pugi::xml_node element_of(const TiledLayerNode& node) const;
  const std::vector<pugi::xml_node>& elements(TiledLayerKind kind) const {
    return kind == TiledLayerKind::tiles     ? layers_
           : kind == TiledLayerKind::objects ? object_layers_
                                             : groups_;
  }
  TiledIds& object_ids();
  TiledIds& layer_ids();
  TiledLayerTree find_layers(const pugi::xml_node& node);
  std::vector<XmlCells> cells_of(int layer) const;
  FormatResult<std::vector<std::uint32_t>> read_cells(const XmlCells& at, std::size_t count) const;
  void put_tiles(const XmlCells& at, const TiledBlock& content);
  TiledEncoding usual_encoding() const;
  void add_data(int layer, const std::string& content);
  std::string new_content(const XmlCells& like, const TiledBlock& content) const;

  std::string_view bytes_;
  std::string own_;  // the same in UTF-8; empty if the bytes are that
  std::string_view text_;
  XmlPlaces places_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::vector<pugi::xml_node> layers_;         // tile layers
  std::vector<pugi::xml_node> object_layers_;  // and those of pictures
  std::vector<pugi::xml_node> groups_;         // each before those in it
  TiledLayerTree tree_;
  std::optional<TiledIds> object_ids_, layer_ids_;
  TextEdits edits_;
};

std::optional<TiledLayerKind> kind_of(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  if (name == "layer") return TiledLayerKind::tiles;
  if (name == "objectgroup" || name == "imagelayer") return TiledLayerKind::objects;
  if (name == "group") return TiledLayerKind::groups;
  return std::nullopt;
}

// Groups are at most as deep as the reader allows.
TiledLayerTree TiledXmlDocument::find_layers(const pugi::xml_node& node) {
  TiledLayerTree tree;
  for (const pugi::xml_node child : node.children()) {
    const auto kind = kind_of(child);
    if (!kind) continue;
    auto& list = *kind == TiledLayerKind::tiles     ? layers_
                 : *kind == TiledLayerKind::objects ? object_layers_
                                                    : groups_;
    tree.push_back({*kind, static_cast<int>(list.size()), child.attribute("name").value()});
    list.push_back(child);
    if (*kind == TiledLayerKind::groups) tree.back().inside = find_layers(child);
  }
  return tree;
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
  std::vector<XmlCells> all_cells = cells_of(layer);
  if (all_cells.empty() && !is_infinite()) all_cells.push_back({node, {}});  // a layer without data
  for (const XmlCells& at : all_cells) {
    TiledBlock block;
    block.is_chunk = is_infinite() || std::string_view(at.element.name()) == "chunk";
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
  const std::vector<XmlCells> all = cells_of(layer);
  if (all.empty())
    return add_data(layer,
                    new_content({layers_[static_cast<std::size_t>(layer)], usual_encoding()}, content));
  const XmlCells& at = all[block];
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
  const pugi::xml_node node = layers_[static_cast<std::size_t>(layer)], data = node.child("data");
  const XmlCells like = data ? cells_of(layer).back() : XmlCells{node, usual_encoding()};
  const bool has_chunks = data && like.element != data;
  const std::string data_break = places_.break_before(data ? data : node);
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
  if (!data) return add_data(layer, text + data_break);
  if (places_.has_inside(data)) return edits_.replace(places_.inside(data), text + data_break);
  append_xml_inside(places_, data, text + data_break, edits_);
}

// That of the first layer with cells.
TiledEncoding TiledXmlDocument::usual_encoding() const {
  for (const pugi::xml_node& layer : layers_) {
    const pugi::xml_node data = layer.child("data");
    if (data) return {data.attribute("encoding").value(), data.attribute("compression").value()};
  }
  return {"csv", ""};
}

// content: that of the new element, in the usual encoding.
void TiledXmlDocument::add_data(int layer, const std::string& content) {
  const TiledEncoding how = usual_encoding();
  const std::string tag =
      "<data" + xml_attribute("encoding", how.encoding) + xml_attribute("compression", how.compression) + ">";
  append_xml_inside(places_, layers_[static_cast<std::size_t>(layer)], tag + content + "</data>", edits_);
}

void TiledXmlDocument::set_looks(TiledLayerKind kind, int layer, const TileLayer& before,
                                 const TileLayer& now) {
  const pugi::xml_node node = elements(kind)[static_cast<std::size_t>(layer)];
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
  const TintEdits edits = tint_edits(before, now, node.attribute("tintcolor").value());
  if (edits.opacity) set_number("opacity", now.opacity);
  if (edits.tint) set("tintcolor", tiled_color(now.tint));
  // A picture of an old map has x and y, which count until it has an offset.
  const bool is_old = std::string_view(node.name()) == "imagelayer" && !node.attribute("offsetx") &&
                      !node.attribute("offsety") && before.offset != now.offset;
  if (before.offset.x != now.offset.x || is_old)
    set_number("offsetx", own(is_old ? "x" : "offsetx", 0) + now.offset.x - before.offset.x);
  if (before.offset.y != now.offset.y || is_old)
    set_number("offsety", own(is_old ? "y" : "offsety", 0) + now.offset.y - before.offset.y);
  if (before.parallax.x != now.parallax.x) set_number("parallaxx", now.parallax.x);
  if (before.parallax.y != now.parallax.y) set_number("parallaxy", now.parallax.y);
  if (before.is_ground != now.is_ground)
    TiledXmlEditor(text_, places_, root_, edits_).set_property(node, {"ground", now.is_ground});
}

void TiledXmlDocument::edit_objects(int layer, const std::vector<TiledObjectEdit>& edits) {
  TiledXmlEditor(text_, places_, root_, edits_)
      .edit_objects(object_layers_[static_cast<std::size_t>(layer)], edits,
                    [&] { return object_ids().take(); });
}

TiledIds& TiledXmlDocument::object_ids() {
  if (object_ids_) return *object_ids_;
  std::vector<std::int64_t> used;
  for (const pugi::xml_node& layer : object_layers_) {
    for (const pugi::xml_node object : layer.children("object"))
      used.push_back(object.attribute("id").as_llong());
  }
  return object_ids_.emplace(std::move(used), root_.attribute("nextobjectid").as_llong());
}

TiledIds& TiledXmlDocument::layer_ids() {
  if (layer_ids_) return *layer_ids_;
  std::vector<std::int64_t> used;
  for (const auto* list : {&layers_, &object_layers_, &groups_})
    for (const pugi::xml_node& node : *list) used.push_back(node.attribute("id").as_llong());
  return layer_ids_.emplace(std::move(used), root_.attribute("nextlayerid").as_llong());
}

std::string TiledXmlDocument::text() const {
  TextEdits all = edits_;
  const auto put = [&](const char* name, const std::optional<TiledIds>& ids) {
    const auto next = ids ? ids->next() : std::nullopt;
    if (next && root_.attribute(name)) set_xml_attribute(places_, root_, name, std::to_string(*next), all);
  };
  put("nextobjectid", object_ids_);
  put("nextlayerid", layer_ids_);
  std::string now = all.applied_to(text_);
  return now == text_ ? std::string(bytes_) : now;
}

std::string TiledXmlDocument::new_layer(const TiledLayerNode& node, const std::string& line) {
  const auto attribute = xml_attribute;
  std::string head =
      root_.attribute("nextlayerid") ? attribute("id", std::to_string(layer_ids().take())) : "";
  head += attribute("name", node.name);
  if (node.kind == TiledLayerKind::objects) return "<objectgroup draworder=\"index\"" + head + "/>";
  head += attribute("width", root_.attribute("width").value()) +
          attribute("height", root_.attribute("height").value());
  const TiledEncoding how = usual_encoding();
  const std::string data =
      "<data" + attribute("encoding", how.encoding) + attribute("compression", how.compression) + "/>";
  const std::string inner = line.empty() ? "" : line + TiledXmlEditor(text_, places_, root_, edits_).unit();
  return "<layer" + head + ">" + inner + data + line + "</layer>";
}

std::string TiledXmlDocument::new_group(const TiledLayerNode& group, const std::string& line) {
  std::string text = "<group";
  if (root_.attribute("nextlayerid")) text += xml_attribute("id", std::to_string(layer_ids().take()));
  text += xml_attribute("name", group.name) + ">";
  const std::string inner = line.empty() ? "" : line + TiledXmlEditor(text_, places_, root_, edits_).unit();
  for (const TiledLayerNode& node : group.inside) text += inner + text_of(node, inner);
  return text + line + "</group>";
}

pugi::xml_node TiledXmlDocument::element_of(const TiledLayerNode& node) const {
  return node.from < 0 ? pugi::xml_node() : elements(node.kind)[static_cast<std::size_t>(node.from)];
}

// A layer as it is, and a group with what is in it now.
std::string TiledXmlDocument::text_of(const TiledLayerNode& node, const std::string& line) {
  const bool is_group = node.kind == TiledLayerKind::groups;
  if (node.from < 0) return is_group ? new_group(node, line) : new_layer(node, line);
  const TextSpan whole = places_.whole(element_of(node));
  if (!is_group) return std::string(whole.in(text_));
  TextEdits inner;
  arrange_in(element_of(node), node.inside, inner);
  const std::string all = inner.applied_to(text_);
  return all.substr(whole.begin, all.size() - (text_.size() - (whole.end - whole.begin)));
}

TiledXmlDocument::Gap TiledXmlDocument::first_gap(const pugi::xml_node& parent, const TiledLayerTree& inside,
                                                  const std::vector<bool>& stays) const {
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (stays[i]) return {element_of(inside[i]), true};
  for (const pugi::xml_node child : parent.children())
    if (kind_of(child)) return {child};
  for (pugi::xml_node child = parent.last_child(); child; child = child.previous_sibling())
    if (child.type() == pugi::node_element) return {child};
  return {};
}

// Texts are put before others are taken away: both may be at one place.
void TiledXmlDocument::arrange_in(const pugi::xml_node& parent, const TiledLayerTree& inside,
                                  TextEdits& edits) {
  std::vector<pugi::xml_node> old;
  for (const pugi::xml_node child : parent.children())
    if (kind_of(child)) old.push_back(child);
  const auto place_of = [&](const pugi::xml_node& element) {
    const auto found = std::find(old.begin(), old.end(), element);
    return found == old.end() ? -1 : static_cast<int>(found - old.begin());
  };
  std::vector<int> places;
  for (const TiledLayerNode& node : inside) places.push_back(node.from < 0 ? -1 : place_of(element_of(node)));
  const std::vector<bool> stays = layers_that_stay(places);
  std::vector<bool> is_kept(old.size());
  Gap gap = first_gap(parent, inside, stays);
  std::string at_end;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (stays[i]) {
      is_kept[static_cast<std::size_t>(places[i])] = true;
      gap = {element_of(inside[i])};
      if (inside[i].kind == TiledLayerKind::groups) arrange_in(gap.beside, inside[i].inside, edits);
      continue;
    }
    const std::string line = gap.beside ? places_.break_before(gap.beside) : "";
    const std::string text = text_of(inside[i], line);
    if (!gap.beside)
      at_end += text;
    else if (gap.is_before)
      edits.insert(places_.whole(gap.beside).begin, text + line);
    else
      edits.insert(places_.whole(gap.beside).end, line + text);
  }
  if (!at_end.empty()) append_xml_inside(places_, parent, at_end, edits);
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (is_kept[i]) continue;
    const TextSpan whole = places_.whole(old[i]);
    edits.replace({whole.begin - places_.break_before(old[i]).size(), whole.end}, "");
  }
}

void TiledXmlDocument::set_layer_size(int layer, int width, int height) {
  const pugi::xml_node node = layers_[static_cast<std::size_t>(layer)];
  set_xml_attribute(places_, node, "width", std::to_string(width), edits_);
  set_xml_attribute(places_, node, "height", std::to_string(height), edits_);
}

void TiledXmlDocument::set_background(const std::string& color) {
  if (color.empty()) return remove_xml_attribute(places_, root_, "backgroundcolor", edits_);
  set_xml_attribute(places_, root_, "backgroundcolor", color, edits_);
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

FormatResult<std::unique_ptr<TiledDocument>> tiled_xml_document(std::string_view bytes, std::string text) {
  auto document = std::make_unique<TiledXmlDocument>(bytes, std::move(text));
  if (!document->read()) return tl::unexpected(FormatError{"", "is not valid XML"});
  return document;
}

}  // namespace talus
