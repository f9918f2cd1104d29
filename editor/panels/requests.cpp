// Requests for the keys, and how long they wait.
#include "requests.h"

namespace talus {
namespace {

bool is_for_keys(const Request& request) {
  return std::holds_alternative<request::FocusField>(request) ||
         std::holds_alternative<request::FocusPanel>(request);
}

}  // namespace

std::string Requests::waiting_for_keys() const {
  std::string names;
  for (const Waiting& each : waiting_) {
    if (const auto* field = std::get_if<request::FocusField>(&each.request)) names += field->name;
    if (const auto* panel = std::get_if<request::FocusPanel>(&each.request)) names += panel->name;
  }
  return names;
}

void Requests::end_frame() {
  std::erase_if(waiting_, [](Waiting& each) {
    return is_for_keys(each.request) && each.frames++ >= kMaxFramesForKeys;
  });
}

}  // namespace talus
