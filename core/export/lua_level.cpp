#include "lua_level.h"

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <talus/level/ground.h>
#include <talus/level/placed_picture.h>
#include "../formats/text/append_number.h"
#include "../level/bump_boxes.h"
#include "lua_parts.h"
#include "lua_text.h"
#include "plain_data.h"
#include "plain_layers.h"

namespace talus {
namespace {

// Writes the members of a table, "key = value" each. The destructor ends the table.
class LuaTable {
 public:
  enum class Layout { small, row, lines };  // as few bytes as possible; all members in a line; one line each
  LuaTable(std::string& text, Layout layout, std::size_t indent = 0)
      : text_(text), layout_(layout), indent_(indent) {
    text_ += '{';
  }
  LuaTable(const LuaTable&) = delete;
  LuaTable& operator=(const LuaTable&) = delete;
  ~LuaTable() {
    if (layout_ == Layout::lines && !is_empty_) text_.append(",\n").append(indent_, ' ');
    text_ += '}';
  }

  std::string& member(std::string_view key) {
    if (!is_empty_) text_ += layout_ == Layout::row ? ", " : ",";
    if (layout_ == Layout::lines) text_.append("\n").append(indent_ + 2, ' ');
    is_empty_ = false;
    if (!key.empty()) text_.append(key).append(layout_ == Layout::small ? "=" : " = ");
    return text_;
  }
  // Tables as members. Those of a small table are small.
  LuaTable in_a_row(std::string_view key) { return {member(key), std::min(layout_, Layout::row)}; }
  // call: what stands before its brace.
  LuaTable in_lines(std::string_view key, std::string_view call = {}) {
    return {member(key).append(call), layout_, indent_ + 2};
  }
  void add(std::string_view text) { text_ += text; }  // to the last member

  void number(std::string_view key, double value) { append_number(member(key), value); }
  void word(std::string_view key, std::string_view value) { member(key).append("\"").append(value) += '"'; }
  void truth(std::string_view key) { member(key) += "true"; }
  // Whether members are written whose values the runtime takes anyway when they are missing.
  bool writes_defaults() const { return layout_ != Layout::small; }
  template <class Range>
  void numbers(std::string_view key, const Range& values) {
    LuaTable list = in_a_row(key);
    for (const auto value : values) list.number("", value);
  }
  // Members without a key, side by side in a line.
  void row(std::span<const TileNumber> values) {
    std::string& text = member("");
    const char* separator = "";
    for (const TileNumber value : values) {
      text.append(separator).append(std::to_string(value));
      separator = ",";
    }
  }

 private:
  std::string& text_;
  Layout layout_;
  std::size_t indent_;  // spaces before the table's end
  bool is_empty_ = true;
};

// What bump_slopes.lua takes of a polygon or a group.
void write_boxes(LuaTable&& list, const TileShape& shape, TileSize tile) {
  for (const BumpBox& made : bump_boxes(shape, tile)) {
    LuaTable table = list.in_a_row("");
    for (const auto& [key, number] :
         {std::pair{"x", made.box.x}, {"y", made.box.y}, {"w", made.box.w}, {"h", made.box.h}})
      table.number(key, number);
    if (!made.line) continue;
    table.number("h0", made.line->h0);
    table.number("h1", made.line->h1);
    if (made.line->is_ceiling) table.truth("ceiling");
    if (made.line->one_way) table.truth("one_way");
  }
}

void write_shape(LuaTable&& table, const TileShape& shape, TileSize tile, bool with_boxes) {
  table.word("kind", kind_word(shape.kind));
  if (shape.side == TileShape::Side::ceiling) table.word("side", "ceiling");
  if (shape.one_way) table.truth("one_way");
  if (shape.conveyor != 0) table.number("conveyor", shape.conveyor);
  if (shape.kind == TileShape::Kind::solid) return;
  if (shape.tiles != 1) table.number("tiles", shape.tiles);
  if (has_heights(shape)) table.numbers("heights", shape.heights);
  if (shape.kind == TileShape::Kind::polygon) {
    std::vector<double> numbers;  // x and y in turn
    for (const Vec2 point : shape.points) numbers.insert(numbers.end(), {point.x, point.y});
    table.numbers("points", numbers);
    numbers.clear();
    for (const auto& [from, to] : shape.lines) numbers.insert(numbers.end(), {from.x, from.y, to.x, to.y});
    if (!numbers.empty()) table.numbers("lines", numbers);
  }
  if (shape.kind == TileShape::Kind::group) {
    LuaTable parts = table.in_a_row("parts");
    for (const TileShape& part : shape.parts) write_shape(parts.in_a_row(""), part, tile, false);
  }
  if (with_boxes && has_parts(shape)) write_boxes(table.in_a_row("boxes"), shape, tile);
}

struct CurveWriter {
  LuaTable& table;
  void operator()(const Segment& s) const {
    table.word("kind", "segment");
    ends(s.from, s.to);
  }
  void operator()(const Arc& a) const {
    table.word("kind", "arc");
    table.number("x", a.center.x);
    table.number("y", a.center.y);
    table.number("radius", a.radius);
    sides(a.x0, a.x1);
    if (a.upper) table.truth("upper");
  }
  void operator()(const Parabola& p) const {
    table.word("kind", "parabola");
    ends(p.from, p.to);
    table.number("control_y", p.control_y);
  }
  void operator()(const Cubic& c) const {
    table.word("kind", "cubic");
    ends(c.from, c.to);
    table.number("slope0", c.from_slope);
    table.number("slope1", c.to_slope);
  }
  void operator()(const Sine& s) const {
    table.word("kind", "sine");
    sides(s.x0, s.x1);
    table.number("middle", s.middle);
    table.number("amplitude", s.amplitude);
    table.number("wavelength", s.wavelength);
    table.number("origin", s.origin);
  }
  void operator()(const Polyline& p) const {
    table.word("kind", "polyline");
    sides(p.x0, p.x1);
    table.numbers("ys", p.ys);
  }
  void sides(double x0, double x1) const {
    table.number("x0", x0);
    table.number("x1", x1);
  }
  void ends(Vec2 from, Vec2 to) const {
    table.number("x0", from.x);
    table.number("y0", from.y);
    table.number("x1", to.x);
    table.number("y1", to.y);
  }
};

void write_curve(LuaTable&& table, const Curve& curve) {
  std::visit(CurveWriter{table}, curve.form);
  if (curve.faces != Curve::Faces::up)
    table.word("faces", curve.faces == Curve::Faces::down ? "down" : "both");
  if (curve.conveyor != 0) table.number("conveyor", curve.conveyor);
}

// A value of JSON as a member. Its keys are names, or what users called their properties.
void write_json(LuaTable& table, const std::string& key, const OrderedJson& value) {
  if (value.is_structured()) {
    LuaTable inner = table.in_a_row(key);
    for (const auto& [name, entry] : value.items())
      write_json(inner,
                 value.is_array()    ? ""
                 : is_lua_name(name) ? name
                                     : "[" + lua_string(name) + "]",
                 entry);
  } else if (value.is_number_float()) {
    table.number(key, value.get<double>());
  } else if (value.is_string()) {
    table.member(key) += lua_string(value.get_ref<const std::string&>());
  } else {
    table.member(key) += value.is_null() ? "nil" : value.dump();
  }
}

// tile: the size of the level's tiles, of which new bodies of a kind have their size.
void write_spawn(LuaTable&& table, const Spawn& spawn, TileSize tile, const Level& level) {
  table.word("kind", traits_of(spawn.kind).word);
  if (!spawn.name.empty()) table.member("name") += lua_string(spawn.name);
  table.number("x", spawn.position.x);
  table.number("y", spawn.position.y);
  const BodyTraits& traits = traits_of(spawn.kind);
  const auto number = [&](std::string_view key, double value, double usual) {
    if (table.writes_defaults() || value != usual) table.number(key, value);
  };
  const Vec2 usual_size = new_body_size(spawn.kind, tile);
  number("w", spawn.size.x, usual_size.x);
  number("h", spawn.size.y, usual_size.y);
  number("vx", spawn.velocity.x, 0);
  number("vy", spawn.velocity.y, 0);
  if (table.writes_defaults() || spawn.used_foot() != traits.foot)
    table.word("foot", foot_word(spawn.used_foot()));
  const BodyPicture picture = on_sheet(spawn.picture, level.sheet(spawn.picture.sheet).layout());
  if (!picture.empty()) write_json(table, "picture", plain_body_picture(picture));
}

// meets: whether the bodies of the level do. Otherwise the form counts for the impulses of events alone.
void write_kind(LuaTable&& table, BodyKind kind, TileSize tile, bool meets) {
  const BodyTraits& traits = traits_of(kind);
  const Vec2 size = new_body_size(kind, tile);
  table.word("rule", rule_word(traits.rule));
  if (traits.takes_keys) table.truth("takes_keys");
  table.number("w", size.x);
  table.number("h", size.y);
  table.word("foot", foot_word(traits.foot));
  table.word("look", look_word(traits.look));
  if (traits.shape == BodyShape::circle && (meets || table.writes_defaults())) table.truth("round");
  if (!meets) return;
  table.number("mass", traits.mass);
  table.number("friction", traits.friction);
  if (traits.bounce) table.number("bounce", *traits.bounce);
}

// Whether nothing tells it from a kind with a role or keys, where bodies do not meet. Carts are short of
// space.
bool moves_like_another(const BodyTraits& traits) {
  return traits.role == TileRole::none && !traits.takes_keys;
}

void write_tiles(LuaTable&& rows, std::span<const TileNumber> cells, int columns, const Progress& progress) {
  const auto width = static_cast<std::size_t>(columns);
  for (std::size_t from = 0; from < cells.size() && progress.at(from, cells.size()); from += width)
    rows.row(cells.subspan(from, width));
}

// By cell, the sum of the bits of its turn, see TileTurn.
void write_turns(LuaTable&& rows, const MapCells& cells, int columns) {
  std::vector<TileNumber> numbers;
  numbers.reserve(cells.size());
  for (const TileTurn turn : cells.turns()) numbers.push_back(static_cast<TileNumber>(turn));
  write_tiles(std::move(rows), numbers, columns, {});
}

template <class Layer>
void write_looks(LuaTable& table, const Layer& layer, bool is_ground) {
  if (!layer.name.empty()) table.member("name") += lua_string(layer.name);
  if (is_ground) table.truth("ground");
  if (!layer.visible) table.truth("hidden");
  const auto number = [&](std::string_view key, double value, double usual) {
    if (value != usual) table.number(key, value);
  };
  number("opacity", layer.opacity, 1);
  number("x", layer.offset.x, 0);
  number("y", layer.offset.y, 0);
  number("parallax_x", layer.parallax.x, 1);
  number("parallax_y", layer.parallax.y, 1);
  if (layer.tint != Rgb{255, 255, 255})
    table.numbers("tint", std::vector<int>{layer.tint.r, layer.tint.g, layer.tint.b});
}

void write_layer(LuaTable&& table, const Level& level, int index) {
  const TileLayer& layer = level.layers.list[static_cast<std::size_t>(index)];
  write_looks(table, layer, layer.is_ground);
  const MapCells& cells = level.cells_of(index);
  write_tiles(table.in_lines("tiles"), cells.tiles(), level.map.width(), {});
  if (cells.has_turned()) write_turns(table.in_lines("turns"), cells, level.map.width());
}

std::vector<double> numbers_of(const PlacedPicture& shown, const LuaPictures& pictures) {
  const PicturePart& part = shown.part;
  const Cell corner = pictures.corners.at(part.picture.get());
  const double w = part.width, h = part.height;
  return {1.0 * (corner.x + part.x),
          1.0 * (corner.y + part.y),
          w,
          h,
          shown.corner.x,
          shown.corner.y,
          shown.right.x / w,
          shown.right.y / w,
          shown.down.x / h,
          shown.down.y / h};
}

// A layer of objects or of a picture.
void write_other(LuaTable&& table, const ObjectLayer& layer, const LuaPictures& pictures) {
  write_looks(table, layer, false);
  if (layer.image && layer.image->part.picture != nullptr) {
    const PicturePart& part = layer.image->part;
    table.numbers("image", numbers_of(placed(part, {}, {1.0 * part.width, 1.0 * part.height}), pictures));
    if (layer.image->repeats_x) table.truth("repeats_x");
    if (layer.image->repeats_y) table.truth("repeats_y");
    return;
  }
  LuaTable parts = table.in_lines("parts");
  for (const std::size_t i : drawn_pictures(layer))
    parts.numbers("", numbers_of(placed(layer.objects[i]), pictures));
}

// count: of the layers of tiles that the level's author made; behind them is the ground of objects.
void write_layers(const Level& level, int count, const LuaPictures* pictures, LuaTable& table) {
  LuaTable layers = table.in_lines("layers");
  for (const auto& [has_tiles, index] : layers_in_order(level)) {
    if (has_tiles && index >= count) continue;
    if (has_tiles)
      write_layer(layers.in_lines(""), level, index);
    else if (pictures != nullptr)
      write_other(layers.in_lines(""), level.objects[static_cast<std::size_t>(index)], *pictures);
  }
}

void write_turned(const Level& level, const LuaPictures& pictures, LuaTable& table) {
  const auto turned = turned_large_tiles(level);
  if (turned.empty()) return;
  LuaTable all = table.in_lines("turned_large_tiles");
  for (auto next = turned.begin(); next != turned.end();) {
    const TileNumber tile = next->first;
    LuaTable turns = all.in_lines("[" + std::to_string(tile) + "]");
    for (; next != turned.end() && next->first == tile; ++next) {
      const PlacedPicture shown =
          placed(level.large_tiles.at(tile), {0, 0}, level.map.tile_size(), next->second);
      turns.numbers("[" + std::to_string(static_cast<int>(next->second)) + "]", numbers_of(shown, pictures));
    }
  }
}

void write_pictures(const Level& level, const LuaPictures& pictures, LuaTable& table) {
  table.word("pictures", "pictures.png");
  if (level.layers.order != RenderOrder()) table.word("render_order", word_of(level.layers.order));
  write_turned(level, pictures, table);
  LuaTable large = table.in_lines("large_tiles");
  for (const auto& [number, tile] : level.large_tiles)
    large.numbers("[" + std::to_string(number) + "]",
                  numbers_of(placed(tile, {0, 0}, level.map.tile_size()), pictures));
}

void write_by_number(LuaTable& table, std::string_view key, const OrderedJson& values) {
  if (values.empty()) return;
  LuaTable list = table.in_lines(key);
  for (const auto& [number, value] : values.items()) write_json(list, "[" + number + "]", value);
}

// In functions of their own where they are many, see lua_text.h.
void write_objects(const Level& level, LuaTable& table) {
  const std::vector<ObjectPlace> objects = objects_in_order(level);
  const auto write = [&](LuaTable&& list, std::size_t from) {
    const std::size_t end = std::min(objects.size(), from + kMaxLuaEntries);
    for (std::size_t i = from; i < end; ++i) write_json(list, "", plain_object_json(level, objects[i]));
  };
  if (objects.size() <= kMaxLuaEntries) return write(table.in_lines("objects"), 0);
  LuaTable parts = table.in_lines("objects", "join");
  for (std::size_t from = 0; from < objects.size(); from += kMaxLuaEntries) {
    write(parts.in_lines("", "function() return "), from);
    parts.add(" end");
  }
}

// What games ask for beside the ground.
void write_data(const Level& level, LuaTable& table) {
  OrderedJson flags = OrderedJson::object();
  for (int tile = 0; tile < level.tile_count(); ++tile)
    if (const FlagSet set = level.tile_flags(static_cast<TileNumber>(tile)); set != 0)
      flags[std::to_string(tile)] = set;
  write_by_number(table, "tile_flags", flags);
  write_by_number(table, "flag_names", plain_flag_names(level));
  if (!level.tilesets.empty()) {
    LuaTable tilesets = table.in_lines("tilesets");
    for (const OrderedJson& tileset : plain_tilesets(level)) write_json(tilesets, "", tileset);
  }
  write_objects(level, table);
}

// The player's gravity has the same key as that of balls.
std::string lua_key(const TuningField& field) {
  return field.group == "player" && field.key == "gravity" ? "player_gravity" : std::string(field.key);
}

// The tiles of each flag with a name. Nothing if no flag has one.
void write_flags(const Level& level, LuaTable& table) {
  const auto& names = level.flag_names;
  if (std::all_of(names.begin(), names.end(), [](const std::string& name) { return name.empty(); })) return;
  LuaTable flags = table.in_lines("flags");
  std::set<std::string> written = {""};
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    const std::string& name = names[static_cast<std::size_t>(flag)];
    if (!written.insert(name).second) continue;
    LuaTable tiles = flags.in_a_row("[" + lua_string(name) + "]");
    for (int tile = 0; tile < level.tile_count(); ++tile)
      if (has_flag(level.tile_flags(static_cast<TileNumber>(tile)), flag))
        tiles.truth("[" + std::to_string(tile) + "]");
  }
}

void write_level(LuaTable&& table, const Level& level, bool with_tiles, const Progress& progress,
                 const Level* layered, const LuaPictures* pictures, const Level* whole) {
  const TerrainSource ground = ground_of(level);
  const auto number_key = [](auto tile) { return "[" + std::to_string(tile) + "]"; };
  table.number("width", ground.width);
  table.number("height", ground.height);
  if (ground.tile != TileSize()) {  // the runtime's default
    table.number("tile_width", ground.tile.width);
    table.number("tile_height", ground.tile.height);
  }
  const Level& drawn = layered == nullptr ? level : *layered;
  if (drawn.sheet(SheetId::tiles).picture != nullptr) table.truth("true_colour");
  if (const Rgba back = background_of(drawn); with_tiles && back.a > 0)
    table.numbers("background", std::vector<int>{back.r, back.g, back.b, back.a});
  if (with_tiles) write_tiles(table.in_lines("tiles"), ground.cells, ground.width, progress);
  {
    LuaTable shapes = table.in_lines("shapes");
    for (std::size_t tile = 0; tile < ground.shapes.size(); ++tile) {
      if (ground.shapes[tile].kind != TileShape::Kind::none)
        write_shape(shapes.in_a_row(number_key(tile)), ground.shapes[tile], ground.tile,
                    table.writes_defaults());
    }
  }
  {
    LuaTable balls = table.in_a_row("balls");
    for (int tile = 0; tile < level.tile_count(); ++tile) {
      const auto kind = body_kind_of_tile(level, static_cast<TileNumber>(tile));
      if (kind) balls.word(number_key(tile), traits_of(*kind).word);
    }
  }
  {
    LuaTable curves = table.in_lines("curves");
    for (const Curve& curve : ground.curves) write_curve(curves.in_a_row(""), curve);
  }
  {
    LuaTable spawns = table.in_lines("spawns");
    for (const Spawn& spawn : level.spawns) write_spawn(spawns.in_a_row(""), spawn, ground.tile, level);
  }
  {
    const bool meets = level.tuning.shared.pairs() == BodyPairs::meet;
    LuaTable kinds = table.in_lines("kinds");
    for (std::size_t i = 0; i < body_kinds().size(); ++i) {
      const auto kind = static_cast<BodyKind>(i);
      const bool is_used = std::any_of(level.spawns.begin(), level.spawns.end(),
                                       [&](const Spawn& spawn) { return spawn.kind == kind; });
      if (!is_used && !meets && !kinds.writes_defaults() && moves_like_another(traits_of(kind))) continue;
      write_kind(kinds.in_a_row("[" + lua_string(traits_of(kind).word) + "]"), kind, ground.tile, meets);
    }
  }
  {
    LuaTable tuning = table.in_lines("tuning");
    for (const TuningField& field : tuning_fields()) {
      if (field.words.empty())
        tuning.number(lua_key(field), field.of(level.tuning));
      else
        tuning.word(lua_key(field), field.word_of(level.tuning));
    }
  }
  if (whole != nullptr) write_data(*whole, table);
  if (!with_tiles) return;
  write_json(table, "roles", plain_roles(level.roles));
  write_flags(level, table);
  if (layered != nullptr) {
    write_layers(*layered, whole->layers.count(), pictures, table);
    if (pictures != nullptr) write_pictures(*layered, *pictures, table);
  } else if (const std::string& name = drawn.layers.list.front().name; !name.empty()) {
    table.member("layer_name") += lua_string(name);
  }
  write_by_number(table, "animations", plain_animations(drawn));
  write_by_number(table, "tile_notes", plain_notes(drawn));
  LuaTable parts = table.in_a_row("parts");
  // A loop over the temporary would not keep it alive.
  const std::vector<std::string> used = lua_parts(level).value();
  for (const std::string& part : used) parts.word("", part);
}

}  // namespace

std::string lua_level(const Level& level, LuaForm form, const Progress& progress, const Level* layered,
                      const LuaPictures* pictures, const Level* whole) {
  const bool is_readable = form == LuaForm::readable;
  if (whole == nullptr && is_readable) whole = layered == nullptr ? &level : layered;
  std::string text;
  if (is_readable) text = "-- A level made with Talus, for talus.lua or bump_slopes.lua. Lengths in px.\n";
  if (whole != nullptr && objects_in_order(*whole).size() > kMaxLuaEntries) text += kLuaJoin;
  text += "return ";
  write_level(LuaTable(text, is_readable ? LuaTable::Layout::lines : LuaTable::Layout::small), level,
              is_readable, progress, layered, pictures, whole);
  return text + '\n';
}

}  // namespace talus
