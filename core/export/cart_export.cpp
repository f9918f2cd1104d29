// TIC-80 cartridges whose code plays the level.
#include "../formats/cart_content.h"
#include "export_targets.h"
#include "lua_level.h"
#include "lua_runtime.h"

namespace talus {
namespace {

FormatResult<Level> playable_cart(const ExportRequest& request) {
  const Level& level = request.level;
  if (!map_fits_cart(level)) {
    return tl::unexpected(FormatError{"", "the map has " + std::to_string(level.map.width()) + "x" +
                                              std::to_string(level.map.height()) +
                                              " cells, and a cart has 240x136: change its size first"});
  }
  FormatResult<std::string> runtime = lua_runtime(request, true);
  if (!runtime) return tl::unexpected(runtime.error());
  const FormatResult<std::string> game = request.read_asset("templates/tic80/main.lua");
  if (!game) return tl::unexpected(game.error());
  CartOrigin cart{.kind = CartOrigin::Kind::text, .comment = "--", .bytes = ""};
  cart.bytes = "-- title:  level\n-- author: made with Talus\n-- script: lua\ntalus=(function()\n" +
               *runtime + "end)()\nlevel=(function()\n" + lua_level(level, false) + "end)()\n" +
               join_lua_parts({*game});
  Level playable = level;
  playable.cart = std::make_shared<const CartOrigin>(std::move(cart));
  return playable;
}

FormatResult<Exported> export_playable(const ExportRequest& request,
                                       FormatResult<Exported> (*write)(const ExportRequest&)) {
  const FormatResult<Level> cart = playable_cart(request);
  if (!cart) return tl::unexpected(cart.error());
  return write({*cart, request.name, request.read_asset});
}

}  // namespace

FormatResult<Exported> export_tic_playable(const ExportRequest& request) {
  return export_playable(request, export_tic);
}

FormatResult<Exported> export_tic_text_playable(const ExportRequest& request) {
  return export_playable(request, export_tic_text);
}

}  // namespace talus
