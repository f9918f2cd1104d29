#include "typed_condition.h"

#include <algorithm>

#include "debug/expression.h"

namespace talus {

bool is_condition(const std::string& text) {
  return !text.empty() && Expression::parse_condition(text).has_value();
}

void add_breakpoint(const std::string& condition, const Session& session, Actions& actions) {
  const int body = session.choices().body;
  const auto& all = session.debugger().breakpoints().all();
  const bool is_there = std::any_of(all.begin(), all.end(), [&](const Breakpoint& breakpoint) {
    return breakpoint.condition == condition && breakpoint.body == body;
  });
  if (!is_there) actions.push_back(action::SetBreakpoint{{.condition = condition, .body = body}});
}

}  // namespace talus
