// The list of actions.
#include "actions.h"

namespace talus {

Actions::Actions() = default;
Actions::Actions(std::initializer_list<Action> actions) : list_(actions) {}
Actions::Actions(const Actions& other) = default;
Actions::Actions(Actions&& other) noexcept = default;
Actions& Actions::operator=(const Actions& other) = default;
Actions& Actions::operator=(Actions&& other) noexcept = default;
Actions::~Actions() = default;

template <class Part>
void Actions::add(Part action) {
  list_.emplace_back(std::move(action));
}

const Action* Actions::begin() const { return list_.data(); }
const Action* Actions::end() const { return list_.data() + list_.size(); }

template void Actions::add(Action);
template void Actions::add(LevelAction);
template void Actions::add(ChoiceAction);
template void Actions::add(RunAction);
template void Actions::add(DebugAction);
template void Actions::add(CheckAction);
template void Actions::add(FileAction);
template void Actions::add(PictureAction);
template void Actions::add(ExportAction);
template void Actions::add(MessageAction);

}  // namespace talus
