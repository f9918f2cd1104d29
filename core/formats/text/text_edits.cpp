// Copies what lies between the changes.
#include "text_edits.h"

#include <algorithm>
#include <cassert>

namespace talus {

std::string TextEdits::applied_to(std::string_view text) const {
  std::vector<const Edit*> in_order;
  for (const Edit& edit : edits_) in_order.push_back(&edit);
  std::stable_sort(in_order.begin(), in_order.end(),
                   [](const Edit* a, const Edit* b) { return a->span.begin < b->span.begin; });
  std::string result;
  std::size_t at = 0;
  for (const Edit* edit : in_order) {
    assert(edit->span.begin >= at && edit->span.end <= text.size() && "edits of a text overlap");
    result.append(text.substr(at, edit->span.begin - at)).append(edit->text);
    at = edit->span.end;
  }
  return result.append(text.substr(at));
}

}  // namespace talus
