#include <talus/level/ldtk_origin.h>

#include <algorithm>

namespace talus {
namespace {

bool is_of_thing(const LdtkMapping::Choice& choice, LdtkMapping::Kind kind, const std::string& of,
                 const std::string& name) {
  return choice.kind == kind && choice.of == of && choice.name == name;
}

}  // namespace

const LdtkMapping::Choice* LdtkMapping::find(Kind kind, const std::string& of,
                                             const std::string& name) const {
  const auto found = std::find_if(choices.begin(), choices.end(),
                                  [&](const Choice& choice) { return is_of_thing(choice, kind, of, name); });
  return found == choices.end() ? nullptr : &*found;
}

void LdtkMapping::set(const Choice& choice) {
  const auto found = std::find_if(choices.begin(), choices.end(), [&](const Choice& known) {
    return is_of_thing(known, choice.kind, choice.of, choice.name);
  });
  const bool says_nothing = choice.shape.empty() && choice.flag.empty() && choice.body.empty();
  if (found == choices.end()) {
    if (!says_nothing) choices.push_back(choice);
  } else if (says_nothing) {
    choices.erase(found);
  } else {
    *found = choice;
  }
}

}  // namespace talus
