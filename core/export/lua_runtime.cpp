// Reads the parts and joins them.
#include "lua_runtime.h"

#include "lua_level.h"

namespace talus {

FormatResult<std::string> lua_runtime(const ExportRequest& request, bool with_mouse) {
  std::vector<std::string> texts;
  for (const std::string& part : lua_runtime_parts(request.level, with_mouse)) {
    FormatResult<std::string> text = request.read_asset("runtime/" + part + ".lua");
    if (!text) return text;
    texts.push_back(std::move(*text));
  }
  return join_lua_parts(texts);
}

std::vector<std::string> dropped_solver(const Level& level) {
  if (level.tuning.solver == SolverKind::exact) return {};
  return {"the solver " + std::string(solver_name(level.tuning.solver)) + ": the game moves by exact"};
}

}  // namespace talus
