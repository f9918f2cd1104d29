// The question about unsaved changes.
#pragma once

#include "panel.h"

namespace talus {

class QuestionPanel : public Panel {
 public:
  std::string_view id() const override { return "question"; }
  std::string_view title() const override { return "Question"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
