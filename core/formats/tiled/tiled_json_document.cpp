// TMJ and TSJ.
#include <algorithm>

#include "../text/append_number.h"
#include "../text/json_places.h"
#include "../text/json_text.h"
#include "tiled_cells.h"
#include "tiled_document.h"
#include "tiled_json_editor.h"
#include "tiled_map.h"

namespace talus {
namespace {

class TiledJsonDocument : public TiledDocument {
 public:
  explicit TiledJsonDocument(std::string_view text) : text_(text), places_(text), root_(places_.root()) {
    find_layers(root_, 0);
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
  void find_layers(TextSpan node, int depth);
  TextSpan layer_at(int layer) const { return layers_[static_cast<std::size_t>(layer)]; }
  // The objects that have the cells: chunks, or the layer itself.
  std::vector<TextSpan> holders(int layer) const;
  TiledEncoding encoding_of(int layer) const;
  bool is_infinite() const {
    const auto infinite = places_.member(root_, "infinite");
    return infinite && infinite->in(text_) == "true";
  }
  std::string value_for(std::string_view old, const TiledEncoding& how, const TiledBlock& content) const;

  std::string_view text_;
  JsonPlaces places_;
  TextSpan root_;
  std::vector<TextSpan> layers_;  // tile layers
  TextEdits edits_;
};

void TiledJsonDocument::find_layers(TextSpan node, int depth) {
  const auto list = places_.member(node, "layers");
  if (!list || depth > kMaxJsonDepth) return;
  for (const TextSpan layer : places_.values(*list)) {
    const std::string type = places_.text_of(layer, "type");
    if (type == "tilelayer") layers_.push_back(layer);
    if (type == "group") find_layers(layer, depth + 1);
  }
}

std::vector<TextSpan> TiledJsonDocument::holders(int layer) const {
  const TextSpan node = layer_at(layer);
  const auto chunks = places_.member(node, "chunks");
  if (chunks && is_infinite()) return places_.values(*chunks);
  if (places_.member(node, "data")) return {node};
  return {};
}

TiledEncoding TiledJsonDocument::encoding_of(int layer) const {
  return {places_.text_of(layer_at(layer), "encoding"), places_.text_of(layer_at(layer), "compression")};
}

FormatResult<std::vector<TiledBlock>> TiledJsonDocument::blocks(int layer) const {
  const TiledEncoding how = encoding_of(layer);
  std::vector<TiledBlock> all;
  for (const TextSpan holder : holders(layer)) {
    TiledBlock block;
    block.is_chunk = is_infinite();
    block.x = block.is_chunk ? places_.number_of(holder, "x") : 0;
    block.y = block.is_chunk ? places_.number_of(holder, "y") : 0;
    block.width = places_.number_of(holder, "width", places_.number_of(root_, "width"));
    block.height = places_.number_of(holder, "height", places_.number_of(root_, "height"));
    const auto count = static_cast<std::size_t>(std::max(block.width, 0)) *
                       static_cast<std::size_t>(std::max(block.height, 0));
    const Json data =
        Json::parse(places_.member(holder, "data").value_or(TextSpan()).in(text_), nullptr, false);
    if (data.is_string() &&
        data.get_ref<const std::string&>().find_first_not_of(" \t\r\n") != std::string::npos) {
      auto cells =
          decode_tiled_cells(data.get_ref<const std::string&>(), how.encoding, how.compression, count);
      if (!cells) return tl::unexpected(FormatError{"", "has a layer that " + cells.error()});
      block.cells = *std::move(cells);
    } else if (data.is_array()) {
      for (const Json& cell : data) block.cells.push_back(cell.is_number() ? cell.get<std::uint32_t>() : 0);
    }
    if (block.cells.empty()) block.cells.assign(count, 0);
    if (block.cells.size() != count)
      return tl::unexpected(
          FormatError{"", "has a layer that " + tiled_count_problem(block.cells.size(), count)});
    all.push_back(std::move(block));
  }
  return all;
}

std::string TiledJsonDocument::value_for(std::string_view old, const TiledEncoding& how,
                                         const TiledBlock& content) const {
  const bool is_text = !old.empty() && old.front() == '"';
  const std::string_view inside = old.empty() ? old : old.substr(1, old.size() - 2);
  const std::string cells = recode_tiled_cells(is_text && how.encoding == "csv" ? "0" : inside,
                                               is_text || how.encoding == "base64" ? how : TiledEncoding(),
                                               content.cells, content.width, line_end_of(text_));
  const bool becomes_text = is_text || how.encoding == "base64";
  return becomes_text ? "\"" + cells + "\"" : "[" + cells + "]";
}

void TiledJsonDocument::put_cells(int layer, std::size_t block, const TiledBlock& content) {
  const TextSpan holder = holders(layer)[block];
  const TextSpan old = *places_.member(holder, "data");
  edits_.replace(old, value_for(old.in(text_), encoding_of(layer), content));
}

void TiledJsonDocument::add_chunks(int layer, const std::vector<TiledBlock>& chunks) {
  const TiledEncoding how = encoding_of(layer);
  std::vector<std::string> texts;
  for (const TiledBlock& chunk : chunks) {
    const std::string data = value_for(how.encoding == "base64" ? "\"\"" : "[0]", how, chunk);
    texts.push_back("{\"data\":" + data + ", \"height\":" + std::to_string(chunk.height) +
                    ", \"width\":" + std::to_string(chunk.width) + ", \"x\":" + std::to_string(chunk.x) +
                    ", \"y\":" + std::to_string(chunk.y) + "}");
  }
  const auto list = places_.member(layer_at(layer), "chunks");
  if (list) return append_json_values(places_, *list, texts, edits_);
  std::string value = "[";
  for (const std::string& text : texts) value += (value.size() > 1 ? ", " : "") + text;
  set_json_member(places_, layer_at(layer), "chunks", value + "]", edits_);
}

void TiledJsonDocument::set_looks(int layer, const TileLayer& before, const TileLayer& now) {
  const TextSpan node = layer_at(layer);
  const auto set = [&](const char* key, const Json& value) {
    set_json_member(places_, node, key, value.dump(-1, ' ', false, Json::error_handler_t::replace), edits_);
  };
  const auto own = [&](const char* key) {
    const auto value = places_.member(node, key);
    const Json number = value ? Json::parse(value->in(text_), nullptr, false) : Json(0);
    return number.is_number() ? number.get<double>() : 0;
  };
  if (before.name != now.name) set("name", now.name);
  if (before.visible != now.visible) set("visible", now.visible);
  if (before.locked != now.locked) set("locked", now.locked);
  if (before.opacity != now.opacity) set("opacity", json_number(now.opacity));
  if (before.tint != now.tint) set("tintcolor", tiled_color(now.tint));
  if (before.offset.x != now.offset.x)
    set("offsetx", json_number(own("offsetx") + now.offset.x - before.offset.x));
  if (before.offset.y != now.offset.y)
    set("offsety", json_number(own("offsety") + now.offset.y - before.offset.y));
  if (before.parallax.x != now.parallax.x) set("parallaxx", json_number(now.parallax.x));
  if (before.parallax.y != now.parallax.y) set("parallaxy", json_number(now.parallax.y));
  if (before.is_ground != now.is_ground)
    TiledJsonEditor(text_, places_, edits_).set_property(node, {"ground", now.is_ground});
}

void TiledJsonDocument::set_size(int width, int height) {
  std::vector<TextSpan> sized = layers_;
  sized.push_back(root_);
  for (const TextSpan node : sized) {
    if (const auto old = places_.member(node, "width")) edits_.replace(*old, std::to_string(width));
    if (const auto old = places_.member(node, "height")) edits_.replace(*old, std::to_string(height));
  }
}

void TiledJsonDocument::edit_tiles(int tileset, const TiledTileEdits& edits) {
  TextSpan node = root_;
  if (const auto list = places_.member(root_, "tilesets")) {
    const std::vector<TextSpan> tilesets = places_.values(*list);
    if (static_cast<std::size_t>(tileset) >= tilesets.size()) return;
    node = tilesets[static_cast<std::size_t>(tileset)];
  }
  TiledJsonEditor(text_, places_, edits_).edit_tiles(node, edits);
}

}  // namespace

FormatResult<std::unique_ptr<TiledDocument>> tiled_json_document(std::string_view bytes) {
  return std::make_unique<TiledJsonDocument>(bytes);
}

}  // namespace talus
