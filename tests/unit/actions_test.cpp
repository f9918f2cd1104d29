// The list of actions. Each action belongs to one domain, whose handler carries it out. The compiler checks
// that the handler does: an action without a carry_out in its handler calls a deleted function.
#include "session/actions.h"

#include <gtest/gtest.h>

#include "session/session.h"

namespace talus::actions_test {
namespace {

template <class A, class... Domains>
constexpr int domains_of(std::type_identity<std::variant<Domains...>>) {
  return (int(kIsOfDomain<A, Domains>) + ...);
}

template <class... Listed>
constexpr bool is_each_of_one_domain(std::type_identity<std::variant<Listed...>>) {
  return ((domains_of<Listed>(std::type_identity<Action>()) == 1) && ...);
}

template <class... Domains>
constexpr bool has_no_action_twice(std::type_identity<std::variant<Domains...>>) {
  return (is_each_of_one_domain(std::type_identity<Domains>()) && ...);
}

static_assert(has_no_action_twice(std::type_identity<Action>()));
static_assert(std::is_same_v<DomainOf<action::Undo, Action>::type, LevelAction>);
static_assert(std::is_same_v<DomainOf<action::DismissMessage, Action>::type, MessageAction>);

TEST(Actions, AreCarriedOutInTheirOrder) {
  Actions actions{action::SetGrid{false}, action::Play{}};
  actions.push_back(action::Pause{});
  actions.push_back(Action(action::SetGrid{true}));
  EXPECT_EQ(actions.end() - actions.begin(), 4);
  Session session;
  session.apply(actions);
  EXPECT_TRUE(session.choices().grid);
  EXPECT_FALSE(session.playback().running);
}

}  // namespace
}  // namespace talus::actions_test
