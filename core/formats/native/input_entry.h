// What is held in a frame, as JSON: {"frame":8,"mouse":[x,y],"down":true,"grab":2,"keys":["left","jump"]}.
#pragma once

#include <vector>

#include "../../level/recording.h"
#include "../text/json_text.h"

namespace talus {

// Changes what `json` has keys for ("keys" lists all that are held) and keeps the rest. Returns what is
// wrong, as a sentence that names the key, or an empty text.
//   "frame"  whole, from 1; must be there.   "mouse"  [x, y], px, within 100 million.
//   "down"   of the button, true or false.   "grab"   whole, from 0: see Input::grab.
//   "keys"   a list of "left", "right" and "jump".
std::string take_input_entry(const Json& json, RecordedInput& entry);

// Reads recorded input of one such entry a line, in order; a key that a line leaves out keeps its value.
// Lines may be empty; frames must not go backwards. Errors name the line.
FormatResult<std::vector<RecordedInput>> read_input_lines(std::string_view text);

// The entry, without what is as in the one before.
Json input_entry(const RecordedInput& entry, const RecordedInput& before);

}  // namespace talus
