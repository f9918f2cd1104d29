#include "body_note.h"

#include "panels/commands/commands.h"

namespace talus {
namespace {

// Above the map it comes back.
bool has_left(const Body& body, const TileMap& map) {
  return body.box.right() < 0 || body.box.x > map.px_width() || body.box.y > map.px_height();
}

}  // namespace

std::string body_note(const Body& body, bool holds, const Session& session, const Ui& ui) {
  const Input& keys = session.playback().input;
  if (!session.playback().running && (holds || keys.left || keys.right || keys.jump))
    return "Paused: " + keys_of("play/toggle"_command, ui) + " plays, " + keys_of("play/step"_command, ui) +
           " steps";
  if (!has_left(body, session.level().map)) return {};
  const bool is_player = traits_of(body.kind).takes_keys;
  return (is_player ? "The player" : "Body " + std::to_string(body.id)) +
         " left the map: " + keys_of("play/run"_command, ui) + " starts again";
}

}  // namespace talus
