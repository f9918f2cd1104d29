// TIC-80 cartridges whose code plays the level.
#include <algorithm>

#include "../formats/cart_content.h"
#include "cart_files.h"
#include "export_targets.h"
#include "lua_level.h"
#include "lua_runtime.h"

namespace talus {
namespace {

// The same cells at the top left of a cart's map, which must have room for them.
TileMap on_cart_map(const TileMap& map) {
  TileMap whole(kTicMapWidth, kTicMapHeight);
  auto to = whole.cells().begin();
  for (auto row = map.cells().begin(); row != map.cells().end(); row += map.width(), to += kTicMapWidth)
    std::copy_n(row, map.width(), to);
  return whole;
}

FormatResult<Level> playable_cart(const ExportRequest& request) {
  const Level& level = request.level;
  if (!map_fits_cart(level)) {
    return tl::unexpected(FormatError{"", "the map has " + std::to_string(level.map.width()) + "x" +
                                              std::to_string(level.map.height()) +
                                              " cells, and a cart has 240x136: change its size first"});
  }
  FormatResult<std::string> runtime = lua_runtime(request, LuaForm::small, true);
  if (!runtime) return tl::unexpected(runtime.error());
  std::vector<std::string> game;
  for (const std::string name : {"camera", "curve_points", "tic80/main"}) {
    if (name == "curve_points" && level.curves.empty()) continue;
    const FormatResult<std::string> text = request.read_asset("templates/" + name + ".lua");
    if (!text) return tl::unexpected(text.error());
    const bool is_module = name != "tic80/main";
    game.push_back(is_module ? name + "=(function()\n" + *text + "end)()\n" : *text);
  }
  CartOrigin cart{.kind = CartOrigin::Kind::text, .comment = "--", .bytes = ""};
  // What is joined begins with code, so that no comment of it is kept: a cart is short of bytes.
  cart.bytes =
      "-- title:  level\n-- author: made with Talus\n-- desc:   arrows run, up or A jumps, the mouse "
      "drags, B starts again\n-- script: lua\n" +
      join_lua({"talus=(function()\n", *runtime, "end)()\n"}) + "level=(function()\n" +
      lua_level(level, LuaForm::small) + "end)()\n" + join_lua(game);
  Level playable = level;
  playable.map = on_cart_map(level.map);  // the code has the level's size
  playable.spawns.clear();
  playable.curves.clear();
  playable.tile_shapes = {};
  playable.flag_shapes = {};
  playable.roles = {};
  playable.tuning = {};
  playable.cart = std::make_shared<const CartOrigin>(std::move(cart));
  return playable;
}

FormatResult<Exported> export_playable(const ExportRequest& request,
                                       FormatResult<Exported> (*write)(const ExportRequest&, const Level&)) {
  const FormatResult<Level> cart = playable_cart(request);
  if (!cart) return tl::unexpected(cart.error());
  FormatResult<Exported> written = write(request, *cart);
  if (!written) return written;
  written->code_bytes = cart->cart->bytes.size();  // a text without sections: code alone
  for (std::string& what : dropped_solver(request.level)) written->dropped.push_back(std::move(what));
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
