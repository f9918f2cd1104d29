// The questions about unsaved changes, and about a file that another program has changed.
#pragma once

#include "panels/panel.h"

namespace talus {

class QuestionPanel : public Panel {
 public:
  std::string_view id() const override { return "question"; }
  std::string_view title() const override { return "Question"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
