// A hard case: a level with the right answer to it, as data. The answers come from closed forms, never from
// running a solver.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <talus/collision/shape.h>

namespace talus {

// One thing that is measured in a run. It passes when what is measured is no more than `bound`.
struct CaseCheck {
  enum class Measure : std::uint8_t {
    position,   // px: distance from the values given, in any frame of the range; the last frame alone by
                // default
    velocity,   // px/frame: the same of the velocity, in `x` and `y`
    sink,       // px under the floor
    gap,        // px above the floor
    reaches,    // px that are missing to `x`, from the side that the body starts on
    backwards,  // px moved back, away from `x`, in a frame
    further,    // px moved further than was asked for in a frame
    walls,      // contacts with a vertical side
    untouched,  // frames without a contact
    normal,     // degrees between `x`, `y` and the normal of any contact; infinite when there is none
    changes,    // frames in which a bit of `y` is not that of the first of the range
    apex,       // px: distance of any highest point of a flight from `y`; infinite when there is none
    mirror,     // px: distance from the same run in the mirrored level, mirrored back
    translate,  // px: the same for the level moved by `x`, `y`, whole tiles
    permute,    // px: the same for the spawns and the curves in reverse order
    repeat      // px: the same for a second run, by a new solver in each frame
  };
  Measure measure = Measure::position;
  int body = 1;                         // id
  std::int64_t first = 0, last = 0;     // frames; 0: as the measure has it by default
  std::optional<double> x, y;           // px, top-left corner; or as the measure says
  std::optional<double> right, bottom;  // px, of the box, instead of x and y
  double bound = 0;
};
struct CaseMeasureInfo {
  CaseCheck::Measure measure;
  std::string_view key;  // in files
};
inline constexpr int kCaseMeasureCount = 16;
const std::array<CaseMeasureInfo, kCaseMeasureCount>& case_measure_infos();  // in the order of the enum

// What is held down from a frame on.
struct CaseInput {
  std::int64_t frame = 1;
  Vec2 mouse;  // px
  bool mouse_down = false;
  bool left = false, right = false, jump = false;
};

// The line that bodies should stand on, for `sink` and `gap`: the highest of its parts.
struct CaseFloor {
  std::vector<std::variant<Segment, Arc, Sine>> parts;
  // px: y of the highest point of the floor from `left` to `right`; nothing where there is no floor.
  std::optional<double> top(double left, double right) const;
};

struct HardCase {
  int number = 0;                           // of the list of hard cases
  std::string title, set_up, right_answer;  // sentences
  std::int64_t frames = 0;                  // steps of a run
  std::vector<CaseInput> input;             // by frame; each holds until the next one
  CaseFloor floor;
  std::vector<CaseCheck> checks;
};

}  // namespace talus
