#include "case_note.h"

#include "sim/case_input.h"

namespace talus {
namespace {

std::string held_text(const Input& input) {
  std::string text;
  const auto add = [&](bool held, const char* key) {
    if (held) text += (text.empty() ? "" : " and ") + std::string(key);
  };
  add(input.left, "Left");
  add(input.right, "Right");
  add(input.jump, "jump");
  add(input.mouse_down, "the mouse");
  return text.empty() ? "nothing now" : text;
}

}  // namespace

std::string case_note(const Session& session) {
  if (!session.hard_case()) return {};
  const HardCase& hard = *session.hard_case();
  if (hard.input.empty())
    return hard.edits.empty() ? ""
                              : "Only the checks of the hard case make its edits; here you make your own";
  const Input own = case_input(hard.input, session.state().frame + 1);
  const Input& user = session.playback().input;
  if ((own.left && user.right) || (own.right && user.left))
    return "The hard case holds " + held_text(own) + " and you hold the opposite key: the two cancel out";
  return "The hard case holds " + held_text(own) + "; your keys count as well";
}

}  // namespace talus
