// TIC-80 cartridges whose code plays the level.
#include <algorithm>

#include <talus/level/ground.h>
#include "../formats/tic80/tic_cart.h"
#include "../formats/tic80/tic_text.h"
#include "../level/with_commas.h"
#include "cart_files.h"
#include "export_targets.h"
#include "lua_level.h"
#include "lua_parts.h"
#include "lua_runtime.h"
#include "short_names.h"

namespace talus {
namespace {

// The same cells at the top left of a cart's map, which must have room for them.
TileMap on_cart_map(const TileMap& map) {
  TileMap whole(kTicMapWidth, kTicMapHeight);
  const std::vector<TileNumber>& cells = map.cells().tiles();
  auto to = whole.cells().tiles().begin();
  for (auto row = cells.begin(); row != cells.end(); row += map.width(), to += kTicMapWidth)
    std::copy_n(row, map.width(), to);
  return whole;
}

// A level as a cart with the game's code; and what of the level's own cart has no place in it.
struct PlayableCart {
  Level level;
  std::size_t code_bytes = 0;
  std::vector<std::string> dropped;
};

// Of the runtime in a cart: tables and fields that games have no use for.
constexpr std::string_view kInnerTables[] = {"Bounce", "Terrain", "Walk"};
constexpr std::string_view kInnerFields[] = {
    "add_free",       "base_x",        "base_y",         "begin_data",    "begin_events",
    "begin_steering", "bends_down",    "compiled",       "convex0",       "convex1",
    "corner_x",       "corner_y",      "covered0",       "covered1",      "depth_below_floor",
    "details",        "direction",     "edge",           "facing",        "falls_away",
    "far0",           "far1",          "is_floor",       "is_ignored",    "is_straight",
    "joint_asked",    "jump_held",     "jumping",        "last0",         "last1",
    "last_id",        "leads_above",   "lowest",         "MOST_PASSED",   "note_free",
    "note_hit",       "note_standing", "note_touch",     "on_end",        "on_line",
    "outline_of",     "PARTS_OF_WAY",  "pieces",         "place_on",      "place_tiles",
    "room_at",        "settled",       "slope_rest",     "some_pieces",   "source",
    "stands_between", "step_bodies",   "straight",       "stretch",       "sunk",
    "take_input",     "top_of_side",   "touched_bottom", "touched_right", "touched_top"};

// The texts that a cart's code is made of.
struct CartTexts {
  bool has_mouse = false;
  std::vector<std::string> runtime;
  std::string level;
  std::vector<std::string> game;
};

// What of a cart's code is to be read. The rest has no comments, no indentation and short names.
enum class CartForm { all, game, nothing };

// Whether there is a body that the mouse alone moves as the player likes.
bool has_body_without_keys(const Level& level) {
  const auto takes_none = [](BodyKind kind) { return !traits_of(kind).takes_keys; };
  const TerrainSource ground = ground_of(level);
  return std::any_of(level.spawns.begin(), level.spawns.end(),
                     [&](const Spawn& spawn) { return takes_none(spawn.kind); }) ||
         std::any_of(ground.cells.begin(), ground.cells.end(), [&](TileNumber tile) {
           const auto kind = body_kind_of_tile(level, tile);
           return kind && takes_none(*kind);
         });
}

FormatResult<CartTexts> cart_texts(const ExportRequest& request) {
  const Level& level = request.level;
  const auto parts =
      lua_parts(level, std::string(request.parts) + (has_body_without_keys(level) ? ",mouse" : ""));
  if (!parts) return tl::unexpected(parts.error());
  const auto has = [&](std::string_view part) {
    return std::find(parts->begin(), parts->end(), part) != parts->end();
  };
  FormatResult<std::vector<std::string>> runtime = cart_runtime(request, *parts);
  if (!runtime) return tl::unexpected(runtime.error());
  CartTexts texts{has("mouse"), *std::move(runtime), {}, {}};
  texts.level = lua_level(level, LuaForm::small, {}, nullptr, nullptr, has("data") ? &level : nullptr);
  const bool has_pictures = std::any_of(level.spawns.begin(), level.spawns.end(),
                                        [](const Spawn& spawn) { return !spawn.picture.empty(); });
  struct Template {
    std::string file;
    bool is_used = true;
    bool is_module = true;  // its text returns what has the file's name then
  };
  for (const Template& part :
       {Template{"area"}, Template{"curve_points", !level.curves.empty()}, Template{"frames", has_pictures},
        Template{"tic80/draw_picture", has_pictures, false},
        Template{"tic80/draw_figure", has("players"), false},
        Template{"tic80/take_mouse", texts.has_mouse, false}, Template{"tic80/main", true, false}}) {
    if (!part.is_used) continue;
    FormatResult<std::string> text = request.read_asset("templates/" + part.file + ".lua");
    if (!text) return tl::unexpected(text.error());
    texts.game.push_back(part.is_module ? part.file + "=(function()\n" + *text + "end)()\n"
                                        : *std::move(text));
  }
  return texts;
}

std::string code_of(const CartTexts& texts, CartForm form) {
  std::string code = "-- title:  level\n-- author: made with Talus\n-- desc:   arrows run, up or A jumps, " +
                     std::string(texts.has_mouse ? "the mouse drags, " : "") +
                     "B starts again\n-- license: MIT, (c) 2026 the Talus authors\n-- script: lua\n";
  if (form == CartForm::game)
    code +=
        "-- First what moves the bodies, in few bytes (the export lua-runtime has it to read), then the "
        "game.\n";
  std::vector<std::string> runtime = {"\n"};  // a text that begins with code keeps none of its comments
  runtime.insert(runtime.end(), texts.runtime.begin(), texts.runtime.end());
  code += "talus=(function()\n" +
          (form == CartForm::all ? brief_lua(texts.runtime)
                                 : with_short_names(join_lua(runtime), {kInnerTables, kInnerFields})) +
          "end)()\nlevel=(function()\n" + texts.level + "end)()\n";
  return code + (form == CartForm::nothing ? join_lua(texts.game) : brief_lua(texts.game));
}

// As much of the code to read as TIC-80's free version holds; and what is not, as in Exported::dropped.
std::string fitting_code(const CartTexts& texts, std::vector<std::string>& dropped) {
  std::string code = code_of(texts, CartForm::all);
  if (code.size() <= kMaxTicCode) return code;
  const std::string would = "with them the code has " + with_commas(code.size()) +
                            " bytes, but TIC-80's free version allows only " + with_commas(kMaxTicCode);
  code = code_of(texts, CartForm::game);
  const bool fits = code.size() <= kMaxTicCode;
  dropped.push_back("comments, indentation and long names of " +
                    std::string(fits ? "what moves the bodies" : "the code") + ": " + would);
  return fits ? code : code_of(texts, CartForm::nothing);
}

// The level's own cart, with its sounds and music; an empty cart if the level has none.
FormatResult<CartContent> own_cart(const Level& level) {
  if (!level.cart) return CartContent();
  const CartOrigin& cart = *level.cart;
  return cart.kind == CartOrigin::Kind::tic ? tic_content(cart.bytes)
                                            : text_content(cart.bytes, cart.comment);
}

FormatResult<PlayableCart> playable_cart(const ExportRequest& request) {
  const Level& level = request.level;
  if (auto problem = tile_problem_of_cart(level)) return tl::unexpected(FormatError{"", *std::move(problem)});
  if (!map_fits_cart(level)) {
    return tl::unexpected(FormatError{"", "the map has " + std::to_string(level.map.width()) + "x" +
                                              std::to_string(level.map.height()) +
                                              " cells, but a cart has only 240x136: resize the map first"});
  }
  const FormatResult<CartTexts> texts = cart_texts(request);
  if (!texts) return tl::unexpected(texts.error());
  std::vector<std::string> unread;
  std::string code = fitting_code(*texts, unread);
  if (code.size() > kCodeLimit) {
    return tl::unexpected(FormatError{"", "the game's code has " + std::to_string(code.size()) +
                                              " bytes, but a cartridge holds at most 524287"});
  }
  FormatResult<CartContent> cart = own_cart(level);
  if (!cart) return tl::unexpected(cart.error());
  PlayableCart made{level, code.size(), {}};
  if (!cart->code.empty())
    made.dropped.push_back("the cart's own code, " + std::to_string(cart->code.size()) +
                           " bytes: the game's code replaces it");
  made.dropped.insert(made.dropped.end(), cart->rest.begin(), cart->rest.end());
  made.dropped.insert(made.dropped.end(), unread.begin(), unread.end());
  cart->code = std::move(code);
  cart->lang = 0;
  Level& playable = made.level;
  playable.map = on_cart_map(level.map);  // the code has the level's size
  playable.spawns.clear();
  playable.curves.clear();
  playable.tile_shapes.assign(playable.tile_shapes.size(), {});
  playable.flag_shapes = {};
  playable.roles = {};
  playable.tuning = {};
  playable.cart = std::make_shared<const CartOrigin>(
      CartOrigin{.kind = CartOrigin::Kind::tic, .comment = "", .bytes = tic_bytes(*cart)});
  return made;
}

FormatResult<Exported> export_playable(const ExportRequest& request,
                                       FormatResult<Exported> (*write)(const ExportRequest&, const Level&)) {
  FormatResult<PlayableCart> cart = playable_cart(request);
  if (!cart) return tl::unexpected(cart.error());
  FormatResult<Exported> written = write(request, cart->level);
  if (!written) return written;
  written->code_bytes = cart->code_bytes;
  for (std::string& what : cart->dropped) written->dropped.push_back(std::move(what));
  for (std::string& what : dropped_physics(request.level)) written->dropped.push_back(std::move(what));
  return written;
}

}  // namespace

FormatResult<Exported> export_tic_playable(const ExportRequest& request) {
  return export_playable(request, tic_files);
}

FormatResult<Exported> export_tic_text_playable(const ExportRequest& request) {
  return export_playable(request, tic_text_files);
}

}  // namespace talus
