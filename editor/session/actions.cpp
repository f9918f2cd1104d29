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

void Actions::add(Action action) { list_.push_back(std::move(action)); }

template <class Domain>
void Actions::take(std::size_t place, void* action) {
  [&]<class... Listed>(std::type_identity<std::variant<Listed...>>) {
    using Take = void (*)(std::vector<Action>&, void*);
    static constexpr Take kTakes[] = {[](std::vector<Action>& list, void* taken) {
      list.emplace_back(std::in_place_type<Domain>, std::in_place_type<Listed>,
                        std::move(*static_cast<Listed*>(taken)));
    }...};
    kTakes[place](list_, action);
  }(std::type_identity<Domain>());
}

const Action* Actions::begin() const { return list_.data(); }
const Action* Actions::end() const { return list_.data() + list_.size(); }

template void Actions::take<LevelAction>(std::size_t, void*);
template void Actions::take<ChoiceAction>(std::size_t, void*);
template void Actions::take<RunAction>(std::size_t, void*);
template void Actions::take<DebugAction>(std::size_t, void*);
template void Actions::take<CheckAction>(std::size_t, void*);
template void Actions::take<FileAction>(std::size_t, void*);
template void Actions::take<PictureAction>(std::size_t, void*);
template void Actions::take<ExportAction>(std::size_t, void*);
template void Actions::take<MessageAction>(std::size_t, void*);

}  // namespace talus
