// talus shot FILE [--frame N] [--overlay a,b] -o PNG

#include "command.h"
#include "platform/shot.h"

namespace talus {
namespace {

struct ShotCommandOptions {
  std::string file, output;
  std::int64_t frame = 0;
  std::vector<std::string> overlays;
  PhysicsOptions physics;
  ShotOptions shot;
};

void shoot(CommandContext& context, ShotCommandOptions& options) {
  std::optional<Level> level = load_or_fail(context, options.file);
  if (!level || !apply_physics(context, options.physics, level->tuning)) return;
  for (const std::string& key : options.overlays) options.shot.overlays.set(*find_overlay(key), true);
  Session session(std::move(*level), options.file);
  for (std::int64_t i = 0; i < options.frame; ++i) session.apply(action::StepFrame{});
  const auto written = write_shot(session, options.shot, options.output);
  if (!written) fail(context, options.output, "", written.error());
}

std::vector<std::string> overlay_keys() {
  std::vector<std::string> keys;
  for (const OverlayInfo& info : overlay_infos()) keys.emplace_back(info.key);
  return keys;
}

}  // namespace

void add_shot_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("shot", "Draw the play view into a PNG, as the editor would");
  auto options = std::make_shared<ShotCommandOptions>();
  command->add_option("FILE", options->file, "Level or cart")->required();
  command->add_option("--frame", options->frame, "Step to this frame first")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000}));
  add_physics_options(*command, options->physics);
  command->add_option("--overlay", options->overlays, "Overlays to draw")
      ->delimiter(',')
      ->check(CLI::IsMember(overlay_keys()));
  command->add_option("--zoom", options->shot.zoom, "Pixels of the picture for one of the level")
      ->check(CLI::Range(1, 16));
  command->add_option("-o,--output", options->output, "PNG to write")->required();
  command->callback([&context, options] { shoot(context, *options); });
}

}  // namespace talus
