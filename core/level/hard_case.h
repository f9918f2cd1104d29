// A hard case: a level and the right answer to it, as data. The answers come from closed forms, never from
// the run of a solver.
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

// One measured quantity of a run. The check passes if the measured value is at most `bound`.
struct CaseCheck {
  enum class Measure : std::uint8_t {
    position,  // px: distance from the given values in any frame of the range, by default only the last frame
    velocity,  // px/frame: the same for the velocity, in `x` and `y`
    sink,      // px under the floor
    gap,       // px above the floor
    reaches,   // px missing to `x`, from the side where the body starts
    backwards,  // px moved back, away from `x`, in a frame
    further,    // px moved further in a frame than asked for
    walls,      // contacts with a vertical side
    untouched,  // frames without a contact
    normal,     // degrees between `x`, `y` and the normal of any contact; infinite if there is no contact
    changes,    // frames in which a bit of `y` differs from that of the first frame of the range
    energy,     // share of the greatest energy of motion that is gained or lost since the start, in any frame
    total_energy,  // the same for the energy of all bodies together, by their masses; ignores `body`
    apex,          // px: distance of any highest point of a flight from `y`; infinite if there is no flight
    returns,       // px: greatest distance of any body in the last frame from where it began; ignores `body`
    mirror,        // px: distance from the same run in the mirrored level, mirrored back
    translate,     // px: the same for the level moved by `x`, `y`, whole tiles
    permute,       // px: the same for the spawns and curves in reverse order
    repeat  // px: the same for a second run, with a new solver in each frame, and for a third one, without
            // records, so that bodies may sleep
  };
  Measure measure = Measure::position;
  int body = 1;                         // id
  std::int64_t first = 0, last = 0;     // frames; 0: the default of the measure
  std::optional<double> x, y;           // px, top-left corner, unless the measure says otherwise
  std::optional<double> right, bottom;  // px, of the box, in place of x and y
  double bound = 0;
};
struct CaseMeasureInfo {
  CaseCheck::Measure measure;
  std::string_view key;  // in files
};
inline constexpr int kCaseMeasureCount = 19;
const std::array<CaseMeasureInfo, kCaseMeasureCount>& case_measure_infos();  // in the order of the enum

// What is held from a frame on.
struct CaseInput {
  std::int64_t frame = 1;
  Vec2 mouse;  // px
  bool mouse_down = false;
  bool left = false, right = false, jump = false;
};

// What is done to the bodies after the step to a frame, in the runs that checks measure. The frame itself is
// measured as it was before. A body that is gone is measured as it was last.
struct CaseEdit {
  std::int64_t frame = 0;    // from 0 to the frames of the case; 0: before the first step
  int remove = 0;            // id of a body that is taken away; 0: none
  bool turns_round = false;  // all velocities and spins are negated
};

// The line that bodies should stand on, for `sink` and `gap`: the highest of its parts counts.
struct CaseFloor {
  std::vector<std::variant<Segment, Arc, Sine>> parts;
  // px: y of the highest point of the floor from `left` to `right`; nothing if there is no floor.
  std::optional<double> top(double left, double right) const;
};

struct HardCase {
  int number = 0;                           // in the list of hard cases
  std::string title, set_up, right_answer;  // sentences
  std::int64_t frames = 0;                  // steps of a run
  std::vector<CaseInput> input;             // by frame; each entry holds until the next one
  std::vector<CaseEdit> edits;              // by frame; of one frame in this order
  CaseFloor floor;
  std::vector<CaseCheck> checks;
};

// The same case for scaled(level, factor), see transform.h: all that has a length or speed is `factor` times
// as large.
HardCase scaled(const HardCase& hard, int factor);

}  // namespace talus
