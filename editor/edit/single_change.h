// An edit of one place of a level.
#pragma once

#include <string>
#include <utility>

#include "edit.h"

namespace talus {

// Returns an edit with this change, or an empty one if the place holds the new value already.
template <class MadeChange>
Edit single_change(std::string label, MadeChange change) {
  Edit edit{std::move(label), {}};
  if (!(change.before == change.after)) edit.changes.emplace_back(std::move(change));
  return edit;
}

}  // namespace talus
