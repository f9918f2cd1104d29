// Actions: everything that a user can do to a session, as values. Panels emit them; Session::apply carries
// them out. Tests and the command palette speak the same language. Each domain has a header of its own, which
// lists its actions, and a handler beside it, which carries them out.
#pragma once

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

  // A: an action of one of the domains, or an Action. An overload for Action would let each caller compile
  // its conversion from all other actions.
  template <class A>
  void push_back(A action) {
    if constexpr (std::is_same_v<A, Action>) {
      add(std::move(action));
    } else {
      using Domain = typename DomainOf<A, Action>::type;
      add(Domain(std::in_place_type<A>, std::move(action)));
    }
  }

  bool empty() const { return begin() == end(); }
  const Action* begin() const;
  const Action* end() const;

 private:
  // Compiled in actions.cpp for Action and each domain, as are the members above: in every panel they would
  // take most of the compile time.
  template <class Part>
  void add(Part action);

  std::vector<Action> list_;
};

}  // namespace talus
