// Panel: a part of the window. It shows the session and answers with actions; it does not know other panels.
#pragma once

#include <string_view>

#include "panels/panel_ids.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class Panel {
 public:
  virtual ~Panel() = default;
  virtual std::string_view id() const = 0;     // prefix of its widgets' names: "flags"
  virtual std::string_view title() const = 0;  // title of its tab or heading
  // Draws into the current ImGui window, in the room that is left.
  virtual void draw(const Session& session, Actions& actions, Ui& ui) = 0;
};

}  // namespace talus
