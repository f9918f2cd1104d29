// libFuzzer: expressions of the debugger. An invalid expression must give a clear error with a place in the
// text. A valid one must have a value, and a completion within the text at every cursor.
#include "debug/completion.h"
#include "debug/expression.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace talus;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  static const Frame frame{std::make_shared<const Scene>(), nullptr, {}, {}, {}, {}};
  const auto expression = Expression::parse(text);
  if (expression) {
    const double value = expression->evaluate(FrameView({&frame}), 1);
    require(expression->type() == ValueType::number || value == 0 || value == 1);
  } else {
    require(expression.error().position <= size && !expression.error().message.empty());
  }
  const Completion completion = complete(text, size / 2);
  require(completion.from <= completion.to && completion.to <= size);
  return 0;
}
