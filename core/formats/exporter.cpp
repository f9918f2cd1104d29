#include "exporter.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "atomic_file.h"
#include "cart_content.h"
#include "lua_level.h"
#include "png_sheet.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

FormatResult<std::string> runtime_of(const Level& level, const ReadAsset& read_asset, bool with_mouse) {
  std::vector<std::string> texts;
  for (const std::string& part : lua_runtime_parts(level, with_mouse)) {
    FormatResult<std::string> text = read_asset("runtime/" + part + ".lua");
    if (!text) return text;
    texts.push_back(std::move(*text));
  }
  return join_lua_parts(texts);
}

// The runtime and the level, for any game in Lua.
FormatResult<Exported> write_lua(const Level& level, const ReadAsset& read_asset) {
  FormatResult<std::string> runtime = runtime_of(level, read_asset, false);
  if (!runtime) return tl::unexpected(runtime.error());
  return Exported{{{"talus.lua", std::move(*runtime)}, {"level.lua", lua_level(level)}}, {}};
}

FormatResult<Exported> write_love(const Level& level, const ReadAsset& read_asset) {
  FormatResult<std::string> runtime = runtime_of(level, read_asset, true);
  if (!runtime) return tl::unexpected(runtime.error());
  Exported out{{{"talus.lua", std::move(*runtime)},
                {"level.lua", lua_level(level)},
                {"sheet.png", write_png_part(level, PngPart::tiles)}},
               {}};
  for (const std::string name : {"main.lua", "conf.lua"}) {
    FormatResult<std::string> text = read_asset("templates/love/" + name);
    if (!text) return tl::unexpected(text.error());
    out.files.push_back({name, std::move(*text)});
  }
  return out;
}

constexpr std::array<Exporter, 2> kExporters = {{
    {"lua", "Lua runtime and level", write_lua},
    {"love", "game for LÖVE 11", write_love},
}};

}  // namespace

FormatResult<Level> playable_cart(const Level& level, const ReadAsset& read_asset) {
  if (!map_fits_cart(level)) {
    return tl::unexpected(FormatError{"", "the map has " + std::to_string(level.map.width()) + "x" +
                                              std::to_string(level.map.height()) +
                                              " cells, and a cart has 240x136: change its size first"});
  }
  FormatResult<std::string> runtime = runtime_of(level, read_asset, true);
  if (!runtime) return tl::unexpected(runtime.error());
  const FormatResult<std::string> game = read_asset("templates/tic80/main.lua");
  if (!game) return tl::unexpected(game.error());
  CartOrigin cart{.kind = CartOrigin::Kind::text, .comment = "--", .bytes = ""};
  cart.bytes = "-- title:  level\n-- author: made with Talus\n-- script: lua\ntalus=(function()\n" +
               *runtime + "end)()\nlevel=(function()\n" + lua_level(level, false) + "end)()\n" +
               join_lua_parts({*game});
  Level playable = level;
  playable.cart = std::make_shared<const CartOrigin>(std::move(cart));
  return playable;
}

std::span<const Exporter> exporters() { return kExporters; }

const Exporter* find_exporter(std::string_view id) {
  const auto found =
      std::find_if(kExporters.begin(), kExporters.end(), [&](const Exporter& e) { return e.id == id; });
  return found == kExporters.end() ? nullptr : &*found;
}

FormatResult<void> write_exported(const Exported& exported, const std::string& folder) {
  for (const ExportedFile& file : exported.files) {
    const std::filesystem::path path = std::filesystem::path(folder) / file.name;
    std::error_code failure;
    std::filesystem::create_directories(path.parent_path(), failure);
    if (failure) return tl::unexpected(FormatError{"", "the folder cannot be made: " + failure.message()});
    if (auto written = write_file_atomic(path.string(), file.bytes); !written) return written;
  }
  return {};
}

}  // namespace talus
