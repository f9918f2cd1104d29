// Maps and tilesets of Tiled as JSON: TMJ and TSJ.
#include <algorithm>
#include <optional>

#include "../import/hex_color.h"
#include "../text/append_number.h"
#include "../text/json_places.h"
#include "../text/json_text.h"
#include "tiled_cells.h"
#include "tiled_document.h"
#include "tiled_ids.h"
#include "tiled_json_editor.h"
#include "tiled_layer_order.h"
#include "tiled_map.h"

namespace talus {
namespace {

class TiledJsonDocument : public TiledDocument {
 public:
  explicit TiledJsonDocument(std::string_view text) : text_(text), places_(text), root_(places_.root()) {
    tree_ = find_layers(root_, 0);
  }

  bool is_map() const override { return places_.text_of(root_, "type", "map") != "tileset"; }
  bool is_infinite() const override {
    const auto infinite = places_.member(root_, "infinite");
    return infinite && (infinite->in(text_) == "true" || places_.number_of(root_, "infinite") != 0);
  }
  int layer_count() const override { return static_cast<int>(layers_.size()); }
  int object_layer_count() const override { return static_cast<int>(object_layers_.size()); }
  FormatResult<std::vector<TiledBlock>> blocks(int layer) const override;
  void put_cells(int layer, std::size_t block, const TiledBlock& content) override;
  void add_chunks(int layer, const std::vector<TiledBlock>& chunks) override;
  void set_looks(TiledLayerKind kind, int layer, const TileLayer& before, const TileLayer& now) override;
  void set_draw_order(int layer, bool by_y) override {
    set_json_member(places_, object_layers_[static_cast<std::size_t>(layer)], "draworder",
                    by_y ? "\"topdown\"" : "\"index\"", edits_);
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
  std::string new_layer(const TiledLayerNode& node);
  std::string new_group(const TiledLayerNode& group);
  // parent: the map or a group.
  void arrange_in(TextSpan parent, const TiledLayerTree& inside, TextEdits& edits);
  std::string text_of(const TiledLayerNode& node);
  const std::vector<TextSpan>& spans(TiledLayerKind kind) const {
    return kind == TiledLayerKind::tiles     ? layers_
           : kind == TiledLayerKind::objects ? object_layers_
                                             : groups_;
  }
  TextSpan span_of(const TiledLayerNode& node) const {
    return spans(node.kind)[static_cast<std::size_t>(node.from)];
  }
  TiledIds& object_ids();
  TiledIds& layer_ids();
  TiledLayerTree find_layers(TextSpan node, int depth);
  TextSpan layer_at(int layer) const { return layers_[static_cast<std::size_t>(layer)]; }
  // The objects that have the cells: the layer itself, or chunks, or both.
  std::vector<TextSpan> holders(int layer) const;
  TiledEncoding encoding_of(int layer) const;
  std::string value_for(std::string_view old, const TiledEncoding& how, const TiledBlock& content) const;
  std::string new_value(const TiledEncoding& how, const TiledBlock& content) const;

  std::string_view text_;
  JsonPlaces places_;
  TextSpan root_;
  std::vector<TextSpan> layers_;         // tile layers
  std::vector<TextSpan> object_layers_;  // and those of pictures
  std::vector<TextSpan> groups_;         // each before those in it
  TiledLayerTree tree_;
  std::vector<std::int64_t> used_layer_ids_;
  std::optional<TiledIds> object_ids_, layer_ids_;
  TextEdits edits_;
};

TiledLayerTree TiledJsonDocument::find_layers(TextSpan node, int depth) {
  TiledLayerTree tree;
  const auto list = places_.member(node, "layers");
  if (!list || depth > kMaxJsonDepth) return tree;
  for (const TextSpan layer : places_.values(*list)) {
    const std::string type = places_.text_of(layer, "type");
    used_layer_ids_.push_back(places_.number_of(layer, "id"));
    const TiledLayerKind kind = type == "tilelayer" ? TiledLayerKind::tiles
                                : type == "group"   ? TiledLayerKind::groups
                                                    : TiledLayerKind::objects;
    auto& all = kind == TiledLayerKind::tiles    ? layers_
                : kind == TiledLayerKind::groups ? groups_
                                                 : object_layers_;
    tree.push_back({kind, static_cast<int>(all.size()), places_.text_of(layer, "name")});
    all.push_back(layer);
    if (kind == TiledLayerKind::groups) tree.back().inside = find_layers(layer, depth + 1);
  }
  return tree;
}

std::vector<TextSpan> TiledJsonDocument::holders(int layer) const {
  const TextSpan node = layer_at(layer);
  const auto data = places_.member(node, "data"), chunks = places_.member(node, "chunks");
  const std::string_view cells = data ? data->in(text_) : "null";
  const bool has_cells = cells != "null" && cells.find_first_not_of("\"[] \t\r\n") != cells.npos;
  std::vector<TextSpan> all = chunks ? places_.values(*chunks) : std::vector<TextSpan>();
  if (has_cells || (all.empty() && !is_infinite())) all.insert(all.begin(), node);
  return all;
}

TiledEncoding TiledJsonDocument::encoding_of(int layer) const {
  return {places_.text_of(layer_at(layer), "encoding"), places_.text_of(layer_at(layer), "compression")};
}

FormatResult<std::vector<TiledBlock>> TiledJsonDocument::blocks(int layer) const {
  const TiledEncoding how = encoding_of(layer);
  std::vector<TiledBlock> all;
  for (const TextSpan holder : holders(layer)) {
    TiledBlock block;
    block.is_chunk = is_infinite() || holder.begin != layer_at(layer).begin;
    block.x = block.is_chunk ? places_.number_of(holder, "x") : 0;
    block.y = block.is_chunk ? places_.number_of(holder, "y") : 0;
    block.width = places_.number_of(holder, "width", places_.number_of(root_, "width"));
    block.height = places_.number_of(holder, "height", places_.number_of(root_, "height"));
    const auto count = static_cast<std::size_t>(std::max(block.width, 0)) *
                       static_cast<std::size_t>(std::max(block.height, 0));
    const auto place = places_.member(holder, "data");
    const Json data = place ? json_part(place->in(text_)) : Json();
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
  const bool is_text = !old.empty() && old.front() == '"' && !how.encoding.empty();
  const std::string_view inside = old.empty() ? old : old.substr(1, old.size() - 2);
  const std::string cells = recode_tiled_cells(is_text && how.encoding == "csv" ? "0" : inside,
                                               is_text || how.encoding == "base64" ? how : TiledEncoding(),
                                               content.cells, content.width, line_end_of(text_));
  const bool becomes_text = is_text || how.encoding == "base64";
  return becomes_text ? "\"" + cells + "\"" : "[" + cells + "]";
}

void TiledJsonDocument::put_cells(int layer, std::size_t block, const TiledBlock& content) {
  const TextSpan holder = holders(layer)[block];
  const TiledEncoding how = encoding_of(layer);
  if (const auto old = places_.member(holder, "data"))
    return edits_.replace(*old, value_for(old->in(text_), how, content));
  set_json_member(places_, holder, "data", new_value(how, content), edits_);
}

std::string TiledJsonDocument::new_value(const TiledEncoding& how, const TiledBlock& content) const {
  return value_for(how.encoding == "base64" ? "\"\"" : "[0]", how, content);
}

void TiledJsonDocument::add_chunks(int layer, const std::vector<TiledBlock>& chunks) {
  const TiledEncoding how = encoding_of(layer);
  std::vector<std::string> texts;
  for (const TiledBlock& chunk : chunks) {
    texts.push_back("{\"data\":" + new_value(how, chunk) + ", \"height\":" + std::to_string(chunk.height) +
                    ", \"width\":" + std::to_string(chunk.width) + ", \"x\":" + std::to_string(chunk.x) +
                    ", \"y\":" + std::to_string(chunk.y) + "}");
  }
  const auto list = places_.member(layer_at(layer), "chunks");
  if (list) return append_json_values(places_, *list, texts, edits_);
  std::string value = "[";
  for (const std::string& text : texts) value += (value.size() > 1 ? ", " : "") + text;
  set_json_member(places_, layer_at(layer), "chunks", value + "]", edits_);
}

void TiledJsonDocument::set_looks(TiledLayerKind kind, int layer, const TileLayer& before,
                                  const TileLayer& now) {
  const TextSpan node = spans(kind)[static_cast<std::size_t>(layer)];
  const auto set = [&](const char* key, const Json& value) {
    set_json_member(places_, node, key, value.dump(-1, ' ', false, Json::error_handler_t::replace), edits_);
  };
  const auto own = [&](const char* key) {
    const auto value = places_.member(node, key);
    const Json number = value ? json_part(value->in(text_)) : Json(0);
    return number.is_number() ? number.get<double>() : 0;
  };
  if (before.name != now.name) set("name", now.name);
  if (before.visible != now.visible) set("visible", now.visible);
  if (before.locked != now.locked) set("locked", now.locked);
  const TintEdits edits = tint_edits(before, now, places_.text_of(node, "tintcolor"));
  if (edits.opacity) set("opacity", json_number(now.opacity));
  if (edits.tint) set("tintcolor", tiled_color(now.tint));
  // A picture of an old map has x and y, which count until it has an offset.
  const bool is_old = places_.text_of(node, "type") == "imagelayer" && !places_.member(node, "offsetx") &&
                      !places_.member(node, "offsety") && !(before.offset == now.offset);
  if (before.offset.x != now.offset.x || is_old)
    set("offsetx", json_number(own(is_old ? "x" : "offsetx") + now.offset.x - before.offset.x));
  if (before.offset.y != now.offset.y || is_old)
    set("offsety", json_number(own(is_old ? "y" : "offsety") + now.offset.y - before.offset.y));
  if (before.parallax.x != now.parallax.x) set("parallaxx", json_number(now.parallax.x));
  if (before.parallax.y != now.parallax.y) set("parallaxy", json_number(now.parallax.y));
  if (before.is_ground != now.is_ground)
    TiledJsonEditor(text_, places_, edits_).set_property(node, {"ground", now.is_ground});
}

void TiledJsonDocument::edit_objects(int layer, const std::vector<TiledObjectEdit>& edits) {
  TiledJsonEditor(text_, places_, edits_)
      .edit_objects(object_layers_[static_cast<std::size_t>(layer)], edits,
                    [&] { return object_ids().take(); });
}

TiledIds& TiledJsonDocument::object_ids() {
  if (object_ids_) return *object_ids_;
  std::vector<std::int64_t> used;
  for (const TextSpan layer : object_layers_) {
    const auto list = places_.member(layer, "objects");
    for (const TextSpan object : list ? places_.values(*list) : std::vector<TextSpan>())
      used.push_back(places_.number_of(object, "id"));
  }
  return object_ids_.emplace(std::move(used), places_.number_of(root_, "nextobjectid"));
}

TiledIds& TiledJsonDocument::layer_ids() {
  if (!layer_ids_) layer_ids_.emplace(used_layer_ids_, places_.number_of(root_, "nextlayerid"));
  return *layer_ids_;
}

std::string TiledJsonDocument::text() const {
  TextEdits all = edits_;
  const auto put = [&](const char* key, const std::optional<TiledIds>& ids) {
    const auto next = ids ? ids->next() : std::nullopt;
    if (next && places_.member(root_, key)) set_json_member(places_, root_, key, std::to_string(*next), all);
  };
  put("nextobjectid", object_ids_);
  put("nextlayerid", layer_ids_);
  return all.applied_to(text_);
}

std::string json_text(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string TiledJsonDocument::new_layer(const TiledLayerNode& node) {
  const std::string id = places_.member(root_, "nextlayerid") ? std::to_string(layer_ids().take()) : "";
  std::string text = id.empty() ? "{" : "{\"id\":" + id + ", ";
  text += "\"name\":" + json_text(node.name) + ", \"opacity\":1, \"visible\":true, \"x\":0, \"y\":0, ";
  if (node.kind == TiledLayerKind::objects)
    return text + "\"draworder\":\"index\", \"objects\":[], \"type\":\"objectgroup\"}";
  const TiledEncoding how = layers_.empty() ? TiledEncoding() : encoding_of(0);
  const bool is_text = how.encoding == "base64";
  if (is_text) text += "\"compression\":\"" + how.compression + "\", \"encoding\":\"" + how.encoding + "\", ";
  text += "\"width\":" + std::to_string(places_.number_of(root_, "width")) +
          ", \"height\":" + std::to_string(places_.number_of(root_, "height")) + ", \"type\":\"tilelayer\", ";
  if (is_infinite()) return text + "\"chunks\":[]}";
  return text + (is_text ? "\"data\":\"\"}" : "\"data\":[]}");
}

std::string TiledJsonDocument::new_group(const TiledLayerNode& group) {
  std::string text = "{";
  if (places_.member(root_, "nextlayerid")) text += "\"id\":" + std::to_string(layer_ids().take()) + ", ";
  text += "\"layers\":[";
  for (std::size_t i = 0; i < group.inside.size(); ++i)
    text += (i > 0 ? ", " : "") + text_of(group.inside[i]);
  return text + "], \"name\":" + json_text(group.name) +
         ", \"opacity\":1, \"type\":\"group\", \"visible\":true, \"x\":0, \"y\":0}";
}

// A layer as it is, and a group with what is in it now.
std::string TiledJsonDocument::text_of(const TiledLayerNode& node) {
  const bool is_group = node.kind == TiledLayerKind::groups;
  if (node.from < 0) return is_group ? new_group(node) : new_layer(node);
  const TextSpan whole = span_of(node);
  if (!is_group) return std::string(whole.in(text_));
  TextEdits inner;
  arrange_in(whole, node.inside, inner);
  const std::string all = inner.applied_to(text_);
  return all.substr(whole.begin, all.size() - (text_.size() - (whole.end - whole.begin)));
}

void TiledJsonDocument::arrange_in(TextSpan parent, const TiledLayerTree& inside, TextEdits& edits) {
  const auto list = places_.member(parent, "layers");
  if (!list) {
    std::string all;
    for (const TiledLayerNode& node : inside) all += (all.empty() ? "" : ", ") + text_of(node);
    if (!all.empty()) set_json_member(places_, parent, "layers", "[" + all + "]", edits);
    return;
  }
  const std::vector<TextSpan> old = places_.values(*list);
  const auto place_of = [&](const TiledLayerNode& node) {
    const auto found = std::find_if(old.begin(), old.end(), [&](TextSpan span) {
      return node.from >= 0 && span.begin == span_of(node).begin;
    });
    return found == old.end() ? -1 : static_cast<int>(found - old.begin());
  };
  std::vector<int> places;
  for (const TiledLayerNode& node : inside) places.push_back(place_of(node));
  const std::vector<bool> stays = layers_that_stay(places);
  std::vector<bool> is_kept(old.size());
  JsonListEdit change;
  const auto first = std::find(stays.begin(), stays.end(), true);
  // Before which value layers come that do not stay.
  std::size_t at = first == stays.end()
                       ? old.size()
                       : static_cast<std::size_t>(places[static_cast<std::size_t>(first - stays.begin())]);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (!stays[i]) {
      change.added.emplace_back(at, text_of(inside[i]));
      continue;
    }
    const auto place = static_cast<std::size_t>(places[i]);
    is_kept[place] = true;
    at = place + 1;
    if (inside[i].kind == TiledLayerKind::groups) arrange_in(old[place], inside[i].inside, edits);
  }
  for (std::size_t i = 0; i < old.size(); ++i)
    if (!is_kept[i]) change.removed.push_back(i);
  if (!change.empty()) change_json_list(places_, *list, change, edits);
}

void TiledJsonDocument::set_layer_size(int layer, int width, int height) {
  std::vector<JsonMemberEdit> sides;
  sides.push_back({"width", std::to_string(width)});
  sides.push_back({"height", std::to_string(height)});
  change_json_members(places_, layer_at(layer), sides, edits_);
}

void TiledJsonDocument::set_background(const std::string& color) {
  const auto value = color.empty() ? std::nullopt : std::optional("\"" + color + "\"");
  change_json_members(places_, root_, {{"backgroundcolor", value}}, edits_);
}

void TiledJsonDocument::set_size(int width, int height) {
  std::vector<TextSpan> sized = {root_};
  sized.insert(sized.end(), layers_.begin(), layers_.end());
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
