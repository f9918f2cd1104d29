// Actions: everything that a user can do to a session, as values. Panels emit them; Session::apply carries
// them out. Tests and the command palette speak the same language. Each domain has a header of its own, which
// lists its actions, and a handler beside it, which carries them out.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "session/checks/check_actions.h"
#include "session/choices/choice_actions.h"
#include "session/debugger/debug_actions.h"
#include "session/editing/level_actions.h"
#include "session/files/export_actions.h"
#include "session/files/file_actions.h"
#include "session/files/picture_actions.h"
#include "session/messages/message_actions.h"
#include "session/run/run_actions.h"

namespace talus {

// An action of any domain; the handler of the domain carries it out.
using Action = std::variant<LevelAction, ChoiceAction, RunAction, DebugAction, CheckAction, FileAction,
                            PictureAction, ExportAction, MessageAction>;

// The number of domains of Action that have the action A; the tests check that it is 1.
template <class A, class Domain>
inline constexpr bool kIsOfDomain = false;
template <class A, class... Listed>
inline constexpr bool kIsOfDomain<A, std::variant<Listed...>> = (std::is_same_v<A, Listed> || ...);

// The first of them, as the member `type`.
template <class A, class Domains>
struct DomainOf;
template <class A, class Domain, class... Rest>
struct DomainOf<A, std::variant<Domain, Rest...>>
    : std::conditional_t<kIsOfDomain<A, Domain>, std::type_identity<Domain>,
                         DomainOf<A, std::variant<Rest...>>> {};
template <class A>
struct DomainOf<A, std::variant<>> {
  static_assert(sizeof(A) == 0, "The action is in the list of no domain.");
};

// The place of the action A in the list of its domain.
template <class A, class Domain>
inline constexpr std::size_t kPlaceIn = 0;
template <class A, class First, class... Rest>
inline constexpr std::size_t kPlaceIn<A, std::variant<First, Rest...>> =
    std::is_same_v<A, First> ? 0 : 1 + kPlaceIn<A, std::variant<Rest...>>;

// The actions since the last look, in order.
class Actions {
 public:
  Actions();
  Actions(std::initializer_list<Action> actions);
  Actions(const Actions& other);
  Actions(Actions&& other) noexcept;
  Actions& operator=(const Actions& other);
  Actions& operator=(Actions&& other) noexcept;
  ~Actions();

  // A: an action of one of the domains, or an Action.
  template <class A>
  void push_back(A action) {
    if constexpr (std::is_same_v<A, Action>) {
      add(std::move(action));
    } else {
      using Domain = typename DomainOf<A, Action>::type;
      take<Domain>(kPlaceIn<A, Domain>, &action);
    }
  }

  bool empty() const { return begin() == end(); }
  const Action* begin() const;
  const Action* end() const;

 private:
  // These are compiled in actions.cpp alone, as are the members above. A panel that made a variant itself
  // would compile how to move and destroy every action there is, which took most of its compile time.
  void add(Action action);
  // Moves out of `action`, which points to an action of the domain, the one at that place of its list.
  template <class Domain>
  void take(std::size_t place, void* action);

  std::vector<Action> list_;
};

}  // namespace talus
