// The question before a group of layers is deleted with what is in it.
#pragma once

#include "panels/panel.h"

namespace talus {

class DeleteGroupPanel : public Panel {
 public:
  std::string_view id() const override { return "delete_group"; }
  std::string_view title() const override { return "Delete group"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;
};

}  // namespace talus
