// CellShapeTool: the base of tools that paint a shape from the press to the release.
#pragma once

#include "level_tool.h"

namespace talus {

class CellShapeTool : public LevelTool {
 public:
  void release(const LevelToolUse& use, Actions& actions) override;
  // The tiles of the shape.
  void draw(ImDrawList& list, const LevelToolUse& use) const override;

 private:
  virtual Edit shape(const Session& session, Cell from, Cell to) const = 0;
};

}  // namespace talus
