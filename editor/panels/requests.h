// Requests: what commands and panels ask other panels to do when they are drawn next.
//
// At most one request of each kind waits: a newer request replaces the older one, and scrolls and zooms add
// up. The panel that carries out a request takes it, so that it happens once; the comment of each kind names
// that panel. A request waits until it is taken, for example until its panel is shown. Only a request for the
// keys is dropped after kMaxFramesForKeys frames, because keys that are pressed meanwhile are held back for
// it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <talus/collision/geometry.h>
#include "panels/files/file_dialog.h"
#include "panels/window/programs.h"

namespace talus {
namespace request {

// To the workspace: brings a panel to the front of its region.
struct ShowTab {
  explicit ShowTab(std::string_view id) : name(id) {}
  std::string name;  // id of the panel
};
// To the control of this name: gets the keys. A menu or a list opens, and a button is pressed.
struct FocusField {
  explicit FocusField(std::string_view widget) : name(widget) {}
  std::string name;
};
// To the workspace: gives the keys to the first control of a panel.
struct FocusPanel {
  explicit FocusPanel(std::string_view id) : name(id) {}
  std::string name;  // id of the panel
};
// To the map, or to the play view where that is alone: brings a cell into sight.
struct ShowCell {
  Cell cell;
};
// To the canvas that was used last: scrolls it.
struct Scroll {
  Vec2 by;  // px of the screen
  void add(const Scroll& older) { by = older.by + by; }
};
// To the same canvas: zooms about its middle.
struct Zoom {
  int steps = 0;  // in (> 0) or out
  void add(const Zoom& older) { steps += older.steps; }
};
// To the same canvas: shows the whole map, or goes back.
struct FitMap {};
// To the same canvas: shows what it showed when the level was opened.
struct ShowOpening {};
// To the same: whether it keeps its zoom while its size changes, also until the next one of these. Shows the
// followed body in its middle.
struct KeepZoom {
  bool on = true;
};
// To the problems panel: scrolls to the chosen problem.
struct ShowProblem {};
// To the same: scrolls to the proof of the level.
struct ShowProof {};
// To the panel of layers: begins to rename a layer.
struct RenameLayer {
  int layer = 0;  // index in Level::layers
};
// To the same: begins to rename a group of layers.
struct RenameGroup {
  int group = 0;  // index in TileLayers::groups
};
// To the breakpoints panel: takes this cell as the place of the new breakpoint.
struct PutBreakpointAt {
  Cell cell;
};
// To the application: opens a dialog for a file.
struct ShowFileDialog {
  FileDialog dialog;
};
// To the application: opens the level in another program.
struct OpenProgram {
  ProgramId program;
};

}  // namespace request

using Request =
    std::variant<request::ShowTab, request::FocusField, request::FocusPanel, request::ShowCell,
                 request::Scroll, request::Zoom, request::FitMap, request::ShowOpening, request::KeepZoom,
                 request::ShowProblem, request::ShowProof, request::RenameLayer, request::RenameGroup,
                 request::PutBreakpointAt, request::ShowFileDialog, request::OpenProgram>;

class Requests {
 public:
  // Frames until a field that should get the keys is drawn and has them, as its panel may have to be shown
  // first.
  static constexpr int kMaxFramesForKeys = 5;

  // R is one of the kinds of Request, here and below.
  template <class R>
  void ask(R request) {
    if (const auto older = take<R>()) {
      if constexpr (requires { request.add(*older); }) request.add(*older);
    }
    waiting_.push_back({std::move(request), 0});
  }

  // Whether a request of this kind waits.
  template <class R>
  bool has() const {
    return find<R>() < waiting_.size();
  }
  // Removes and returns the request of this kind; nothing if none waits.
  template <class R>
  std::optional<R> take() {
    const std::size_t at = find<R>();
    if (at == waiting_.size()) return std::nullopt;
    std::optional<R> taken = std::get<R>(std::move(waiting_[at].request));
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(at));
    return taken;
  }

  // The same for a request with this name, for the kinds that have one.
  template <class R>
  bool has(std::string_view name) const {
    const std::size_t at = find<R>();
    return at < waiting_.size() && std::get<R>(waiting_[at].request).name == name;
  }
  template <class R>
  bool take(std::string_view name) {
    return has<R>(name) && take<R>();
  }

  // The names of the field and of the panel that wait for the keys, joined; empty if nothing waits.
  std::string waiting_for_keys() const;
  // Call this once in each frame, after the panels are drawn.
  void end_frame();

 private:
  struct Waiting {
    Request request;
    int frames = 0;  // number of frames that it has waited
  };
  // The index of the request of this kind, or waiting_.size() if none waits.
  template <class R>
  std::size_t find() const {
    std::size_t at = 0;
    while (at < waiting_.size() && !std::holds_alternative<R>(waiting_[at].request)) ++at;
    return at;
  }

  std::vector<Waiting> waiting_;
};

}  // namespace talus
