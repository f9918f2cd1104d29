// talus new --tiles PNG -o LEVEL.talus.json

#include "png_convert.h"

namespace talus {
namespace {

// "16x16", or "16" for both sides. Nothing for other texts.
std::optional<TileSize> sides_of(const std::string& text) {
  const auto number = [](const std::string& digits) {
    constexpr std::size_t kMax = 7;
    const bool good = !digits.empty() && digits.size() <= kMax &&
                      digits.find_first_not_of("0123456789") == std::string::npos;
    return good ? std::stoi(digits) : 0;
  };
  const std::size_t cross = text.find('x');
  const TileSize sides{number(text.substr(0, cross)),
                       number(cross == std::string::npos ? text : text.substr(cross + 1))};
  return sides.width > 0 && sides.height > 0 ? std::optional(sides) : std::nullopt;
}

std::string problem_of_sides(const std::string& text) {
  return sides_of(text) ? "" : "must be WIDTHxHEIGHT, as in 16x16";
}

}  // namespace

void add_new_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("new", "Make an empty level with the tiles of a PNG");
  auto order = std::make_shared<LevelFromTiles>();
  auto tile = std::make_shared<std::string>();
  auto size = std::make_shared<std::string>("60x34");
  command->add_option("--tiles", order->picture, "The PNG with the tiles")->required();
  command->add_option("-o,--output", order->output, "Native level to write; - for standard output")
      ->required();
  command
      ->add_option("--tile-size", *tile,
                   "WIDTHxHEIGHT of a tile, px; default: guessed with spacing and margin")
      ->check(problem_of_sides);
  CLI::Option* spacing = command->add_option("--spacing", order->spacing, "px between two tiles");
  CLI::Option* margin = command->add_option("--margin", order->margin, "px around all tiles");
  for (CLI::Option* gap : {spacing, margin}) gap->check(CLI::Range(0, kMaxTileGap))->needs("--tile-size");
  command->add_option("--size", *size, "COLUMNSxROWS of the map; default: 60x34")->check(problem_of_sides);
  command->add_flag(
      "--link", order->is_linked,
      "Store the PNG's path instead of its pixels: the PNG must be in the level's folder, or below");
  command->callback([&context, order, tile, size] {
    if (!tile->empty()) order->tile = sides_of(*tile);
    order->size = *sides_of(*size);
    make_level_from_tiles(context, *order);
  });
}

}  // namespace talus
