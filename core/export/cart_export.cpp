// TIC-80 cartridges whose code plays the level.
#include <algorithm>

#include "../formats/tic80/tic_cart.h"
#include "../formats/tic80/tic_text.h"
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

FormatResult<std::string> game_code(const ExportRequest& request) {
  const Level& level = request.level;
  FormatResult<std::string> runtime = lua_runtime(request, LuaForm::small, true);
  if (!runtime) return tl::unexpected(runtime.error());
  const auto parts = lua_parts(level, request.parts);
  if (!parts) return tl::unexpected(parts.error());
  const bool has_data = std::find(parts->begin(), parts->end(), "data") != parts->end();
  std::vector<std::string> game;
  const bool has_pictures = std::any_of(level.spawns.begin(), level.spawns.end(),
                                        [](const Spawn& spawn) { return !spawn.picture.empty(); });
  for (const std::string name : {"area", "curve_points", "frames", "tic80/main"}) {
    if ((name == "curve_points" && level.curves.empty()) || (name == "frames" && !has_pictures)) continue;
    const FormatResult<std::string> text = request.read_asset("templates/" + name + ".lua");
    if (!text) return tl::unexpected(text.error());
    const bool is_module = name != "tic80/main";
    game.push_back(is_module ? name + "=(function()\n" + *text + "end)()\n" : *text);
  }
  // A text that begins with code keeps none of its comments: space in a cart is short.
  return "-- title:  level\n-- author: made with Talus\n-- desc:   arrows run, up or A jumps, the mouse "
         "drags, B starts again\n-- license: MIT, (c) 2026 the Talus authors\n-- script: "
         "lua\ntalus=(function()\n" +
         with_short_names(join_lua({"\n", *runtime}), {kInnerTables, kInnerFields}) +
         "end)()\nlevel=(function()\n" +
         lua_level(level, LuaForm::small, {}, nullptr, nullptr, has_data ? &level : nullptr) + "end)()\n" +
         join_lua(game);
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
  FormatResult<std::string> code = game_code(request);
  if (!code) return tl::unexpected(code.error());
  if (code->size() > kCodeLimit) {
    return tl::unexpected(FormatError{"", "the game's code has " + std::to_string(code->size()) +
                                              " bytes, but a cartridge holds at most 524287"});
  }
  FormatResult<CartContent> cart = own_cart(level);
  if (!cart) return tl::unexpected(cart.error());
  PlayableCart made{level, code->size(), {}};
  if (!cart->code.empty())
    made.dropped.push_back("the cart's own code, " + std::to_string(cart->code.size()) +
                           " bytes: the game's code replaces it");
  made.dropped.insert(made.dropped.end(), cart->rest.begin(), cart->rest.end());
  cart->code = *std::move(code);
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
