// Tiled's JSON and its Lua: the same tables in two syntaxes.
#include <cstdio>
#include <string_view>

#include <talus/level/placed_picture.h>
#include "../formats/import/hex_color.h"
#include "../formats/text/append_number.h"
#include "../formats/tiled/tiled_cells.h"
#include "../level/layer_tree.h"
#include "lua_text.h"
#include "tiled_model.h"

namespace talus {
namespace {

// Nested tables and lists, with one line for each member, or all on one line.
class TableText {
 public:
  enum class Syntax { json, lua };
  explicit TableText(Syntax syntax) : is_lua_(syntax == Syntax::lua) {}

  bool is_lua() const { return is_lua_; }
  std::string take() {
    if (joins_) text_.insert(0, kLuaJoin);
    return std::move(text_);
  }
  void begin_text(std::string_view text) { text_ += text; }

  // key: empty for an entry of a list.
  void open(std::string_view key, bool is_list, bool in_line = false) {
    member(key);
    text_ += is_list && !is_lua_ ? '[' : '{';
    open_.push_back({is_list, in_line || (!open_.empty() && open_.back().in_line), true});
  }
  void close() {
    const Table table = open_.back();
    open_.pop_back();
    if (!table.is_empty && !table.in_line) break_line();
    text_ += table.is_list && !is_lua_ ? ']' : '}';
  }

  // A Lua list in parts, see kLuaJoin: open_parts(), then open_part() and close_part() for each part, then
  // close().
  void open_parts(std::string_view key) {
    member(key) += "join{";
    open_.push_back({true, false, true});
    joins_ = true;
  }
  void open_part() {
    member("") += "function() return {";
    open_.push_back({true, false, true});
  }
  void close_part() {
    close();
    text_ += " end";
  }

  void put(std::string_view key, bool value) { member(key) += value ? "true" : "false"; }
  void put(std::string_view key, const char* value) { put(key, std::string_view(value)); }
  void put(std::string_view key, std::string_view value) { append_quoted(member(key), value); }
  template <class Number>
  void put(std::string_view key, Number value) {
    append_number(member(key), value);
  }
  void put(std::string_view key, const TiledProperty& property) {
    std::visit([&](const auto& value) { put(key, value); }, property.value);
  }
  void put(std::string_view key, const std::string& value) { put(key, std::string_view(value)); }

  // A name of the user's as a key.
  void put_named(const TiledProperty& property) {
    std::string key;
    append_quoted(key, property.name);
    put("[" + key + "]", property);
  }

  // Numbers in rows of `width`.
  void put_rows(std::string_view key, const std::vector<std::uint32_t>& numbers, int width) {
    open(key, true);
    open_.back().is_empty = numbers.empty();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i % static_cast<std::size_t>(width) == 0) break_line();
      append_number(text_, numbers[i]);
      if (i + 1 < numbers.size()) text_ += ',';
    }
    close();
  }

 private:
  struct Table {
    bool is_list, in_line, is_empty;
  };

  std::string& member(std::string_view key) {
    if (!open_.empty()) {
      Table& table = open_.back();
      if (!table.is_empty) text_ += ',';
      if (!table.in_line)
        break_line();
      else if (!table.is_empty)
        text_ += ' ';
      table.is_empty = false;
    }
    if (key.empty()) return text_;
    if (is_lua_) return text_.append(key).append(" = ");
    return text_.append("\"").append(key).append("\": ");
  }
  void break_line() { text_.append("\n").append(open_.size(), ' '); }

  void append_quoted(std::string& text, std::string_view value) const {
    if (is_lua_) {
      text += lua_string(value);
      return;
    }
    text += '"';
    for (const char c : value) {
      const auto byte = static_cast<unsigned char>(c);
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(byte));
      if (c == '"' || c == '\\')
        text.append("\\") += c;
      else if (byte < 32)
        text += escape;
      else
        text += c;
    }
    text += '"';
  }

  bool is_lua_;
  bool joins_ = false;  // whether a list is written in parts
  std::string text_;
  std::vector<Table> open_;
};

std::string_view type_name(const TiledProperty& property) {
  constexpr std::string_view kNames[] = {"bool", "int", "float", "string"};
  return kNames[property.value.index()];
}

class TiledTextWriter {
 public:
  explicit TiledTextWriter(TableText::Syntax syntax) : text_(syntax) {}

  std::string write(const TiledMap& map) {
    if (text_.is_lua()) text_.begin_text("return ");
    text_.open("", false);
    if (text_.is_lua())
      text_.put("luaversion", "5.1");
    else
      text_.put("type", "map");
    text_.put("version", kTiledFormat);
    text_.put("tiledversion", kTiledVersion);
    text_.put("orientation", "orthogonal");
    text_.put("renderorder", word_of(map.order));
    text_.put("width", map.width);
    text_.put("height", map.height);
    text_.put("tilewidth", map.tile_size.width);
    text_.put("tileheight", map.tile_size.height);
    if (!text_.is_lua()) text_.put("infinite", false);
    if (!map.background.empty()) color("backgroundcolor", map.background);
    properties(map.properties);
    text_.open("tilesets", true);
    for (const TiledTileset& set : map.tilesets) tileset(set);
    text_.close();
    text_.open("layers", true);
    for (const TiledLayer& one : map.layers) {
      enter_groups(map.groups, one.looks.group);
      layer(one, map);
    }
    enter_groups(map.groups, -1);
    text_.close();
    text_.put("nextlayerid", next_layer_);
    text_.put("nextobjectid", next_object_);
    text_.close();
    return text_.take() + "\n";
  }

 private:
  void properties(const TiledProperties& properties) {
    if (text_.is_lua()) {  // readers need the table even if it is empty
      text_.open("properties", false, true);
      for (const TiledProperty& property : properties) text_.put_named(property);
      text_.close();
    } else if (!properties.empty()) {
      text_.open("properties", true);
      for (const TiledProperty& property : properties) {
        text_.open("", false, true);
        text_.put("name", property.name);
        text_.put("type", type_name(property));
        text_.put("value", property);
        text_.close();
      }
      text_.close();
    }
  }

  // hex: as in tiled_background. Tiled's Lua has three numbers, and the opacity as a fourth if it is not
  // full.
  void color(std::string_view key, const std::string& hex) {
    if (!text_.is_lua()) return text_.put(key, hex);
    text_.open(key, true, true);
    const Rgba color = rgba_of_hex(hex).value_or(Rgba{});
    for (const int part : {color.r, color.g, color.b}) text_.put("", part);
    if (color.a != 255) text_.put("", int{color.a});
    text_.close();
  }

  void tileset(const TiledTileset& set) {
    text_.open("", false);
    text_.put("name", set.name);
    text_.put("firstgid", set.first_gid);
    text_.put("tilewidth", set.tile_size.width);
    text_.put("tileheight", set.tile_size.height);
    text_.put("spacing", set.spacing);
    text_.put("margin", set.margin);
    text_.put("columns", set.columns);
    text_.put("tilecount", set.tile_count);
    if (!set.is_collection) {
      text_.put("image", set.image);
      text_.put("imagewidth", set.image_width);
      text_.put("imageheight", set.image_height);
    }
    if (text_.is_lua()) {
      point("tileoffset", {});
      properties({});
    }
    text_.open("tiles", true);
    for (const TiledTile& one : *set.tiles) tile(one);
    text_.close();
    text_.close();
  }

  void tile(const TiledTile& tile) {
    text_.open("", false);
    text_.put("id", tile.id);
    if (!tile.type.empty()) text_.put("type", tile.type);
    if (tile.probability != 1) text_.put("probability", tile.probability);
    if (!tile.image.empty()) {
      text_.put("image", tile.image);
      text_.put(text_.is_lua() ? "width" : "imagewidth", tile.image_size.width);
      text_.put(text_.is_lua() ? "height" : "imageheight", tile.image_size.height);
    }
    properties(tile.properties);
    if (!tile.objects.empty()) {
      text_.open(text_.is_lua() ? "objectGroup" : "objectgroup", false);
      text_.put("type", "objectgroup");
      text_.put("name", "");
      text_.put("draworder", "index");
      placement(TileLayer());
      properties({});
      int id = 0;  // counts within each tile
      objects(tile.objects, id);
      text_.close();
    }
    if (!tile.animation.empty()) animation(tile.animation);
    text_.close();
  }

  void animation(const std::vector<TiledTile::Frame>& frames) {
    text_.open("animation", true);
    for (const TiledTile::Frame& frame : frames) {
      text_.open("", false, true);
      text_.put("tileid", frame.id);
      text_.put("duration", frame.duration);
      text_.close();
    }
    text_.close();
  }

  // The place of a layer, and whether it is shown. Tiled reads what is missing in JSON as 0 and false.
  template <class Layer>
  void placement(const Layer& looks) {
    text_.put("x", 0);
    text_.put("y", 0);
    text_.put("opacity", looks.opacity);
    text_.put("visible", looks.visible);
    if (text_.is_lua() || looks.offset != Vec2()) {
      text_.put("offsetx", looks.offset.x);
      text_.put("offsety", looks.offset.y);
    }
    if (looks.locked) text_.put("locked", true);
    if (looks.parallax != Vec2{1, 1}) {
      text_.put("parallaxx", looks.parallax.x);
      text_.put("parallaxy", looks.parallax.y);
    }
    if (looks.tint != Rgb{255, 255, 255}) color("tintcolor", tiled_color(looks.tint));
  }

  // Closes the groups that the next layer is not in, and opens those that it is in.
  void enter_groups(const LayerGroups& groups, int group) {
    const std::vector<int> around = groups_around(groups, group);
    std::size_t same = 0;
    while (same < open_.size() && same < around.size() && open_[same] == around[same]) ++same;
    for (; open_.size() > same; open_.pop_back()) {
      text_.close();
      text_.close();
    }
    for (std::size_t i = same; i < around.size(); ++i) {
      const LayerGroup& its = groups[static_cast<std::size_t>(around[i])];
      text_.open("", false);
      text_.put("type", "group");
      text_.put("id", next_layer_++);
      text_.put("name", its.name);
      placement(its);
      text_.open("layers", true);
      open_.push_back(around[i]);
    }
  }

  void layer(const TiledLayer& layer, const TiledMap& map) {
    text_.open("", false);
    text_.put("type", layer.has_tiles ? "tilelayer" : layer.image ? "imagelayer" : "objectgroup");
    text_.put("id", next_layer_++);
    text_.put("name", layer.name);
    TileLayer looks = layer.looks;
    looks.visible = looks.visible && !layer.is_hidden;
    placement(looks);
    properties(layer.has_tiles ? tiled_properties(looks) : layer.properties);
    if (layer.image) {
      text_.put("image", layer.image->path);
      if (layer.image->repeats_x) text_.put("repeatx", true);
      if (layer.image->repeats_y) text_.put("repeaty", true);
    } else if (layer.has_tiles) {
      text_.put("width", map.width);
      text_.put("height", map.height);
      if (text_.is_lua()) text_.put("encoding", "lua");
      cells(layer.cells, map.width);
    } else {
      text_.put("draworder", layer.by_y ? "topdown" : "index");
      int id = next_object_ - 1;
      objects(layer.objects, id);
      next_object_ = id + 1;
    }
    text_.close();
  }

  void cells(const std::vector<std::uint32_t>& cells, int width) {
    if (text_.is_lua() || cells.size() <= kMaxListedCells) return text_.put_rows("data", cells, width);
    text_.put("encoding", "base64");
    text_.put("compression", "zlib");
    text_.put("data", encode_tiled_cells(cells));
  }

  void objects(const std::vector<TiledObject>& objects, int& id) {
    const bool in_parts = text_.is_lua() && objects.size() > kMaxLuaEntries;
    if (in_parts)
      text_.open_parts("objects");
    else
      text_.open("objects", true);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const bool begins_part = in_parts && i % kMaxLuaEntries == 0;
      if (begins_part && i > 0) text_.close_part();
      if (begins_part) text_.open_part();
      object(objects[i], ++id);
    }
    if (in_parts) text_.close_part();
    text_.close();
  }

  // As Tiled calls it.
  static const char* form_of(const TiledObject& object) {
    using Form = TiledObject::Form;
    if (!object.points.empty()) return object.form == Form::polygon ? "polygon" : "polyline";
    if (object.form == Form::ellipse) return "ellipse";
    return is_point(object) ? "point" : "rectangle";
  }

  void object(const TiledObject& object, int id) {
    const char* const form = form_of(object);
    text_.open("", false, text_.is_lua());  // Lua has one line for each
    text_.put("id", id);
    text_.put("name", object.name);
    text_.put("type", object.type);
    if (text_.is_lua())
      text_.put("shape", form);
    else if (object.form == TiledObject::Form::ellipse || is_point(object))
      text_.put(form, true);
    if (object.gid != 0) text_.put("gid", object.gid);
    text_.put("x", object.position.x);
    text_.put("y", object.position.y);
    text_.put("width", object.size.x);
    text_.put("height", object.size.y);
    text_.put("rotation", object.rotation);
    text_.put("visible", object.visible);
    properties(object.properties);
    if (!object.points.empty()) {
      text_.open(form, true, true);
      for (const Vec2 p : object.points) point("", p);
      text_.close();
    }
    text_.close();
  }

  void point(std::string_view key, Vec2 p) {
    text_.open(key, false, true);
    text_.put("x", p.x);
    text_.put("y", p.y);
    text_.close();
  }

  TableText text_;
  int next_layer_ = 1, next_object_ = 1;
  std::vector<int> open_;  // the groups of the last layer
};

}  // namespace

std::string tiled_json_text(const TiledMap& map) {
  return TiledTextWriter(TableText::Syntax::json).write(map);
}
std::string tiled_lua_text(const TiledMap& map) { return TiledTextWriter(TableText::Syntax::lua).write(map); }

}  // namespace talus
