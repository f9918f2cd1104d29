#include "until.h"

#include <ostream>

#include "debug/explain.h"
#include "trace.h"

namespace talus {
namespace {

std::optional<ArmedBreakpoint> armed(const std::string& condition) {
  if (condition.empty()) return std::nullopt;
  auto made = ArmedBreakpoint::arm({.id = 1, .condition = condition});
  return made ? std::optional(std::move(*made)) : std::nullopt;
}

}  // namespace

Until::Until(const std::string& condition)
    : condition_(armed(condition)), history_(condition_ ? condition_->frames_before() : 0) {}

bool Until::stops_at(Frame frame) {
  if (!condition_) return false;
  history_.next() = std::move(frame);
  body_ = condition_->hit(history_.view());
  return body_.has_value();
}

std::int64_t Until::run(const FrameSource& source, std::int64_t last,
                        FunctionRef<bool(double share)> goes_on) {
  for (std::int64_t i = 0; i <= last && goes_on(static_cast<double>(i) / static_cast<double>(last + 1));
       ++i) {
    Frame frame;
    source.read(i, frame);
    if (stops_at(std::move(frame))) return i;
  }
  return last;
}

void Until::report(CommandContext& context, const std::string& file) const {
  if (!condition_) return;
  const FrameView view = history_.view();
  const std::int64_t frame = view.now().state.frame;
  if (!body_) {
    return fail(context, file, "",
                "\"" + condition_->breakpoint().condition + "\" does not hold in any of the frames 0 to " +
                    std::to_string(frame));
  }
  context.out << trace_line(view.now().state, &view.now().record) << '\n';
  if (const std::string why = explain_step(view, *body_); !why.empty()) say(context.out, why);
}

std::string problem_of_condition(const std::string& condition) {
  const auto parsed = Expression::parse_condition(condition);
  if (parsed) return "";
  return "at " + std::to_string(parsed.error().position + 1) + ": " + parsed.error().message;
}

}  // namespace talus
