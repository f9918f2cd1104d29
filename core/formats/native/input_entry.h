// The input of a frame as JSON: {"frame":8,"mouse":[x,y],"down":true,"grab":2,"keys":["left","jump"]}.
#pragma once

#include <vector>

#include "../../level/recording.h"
#include "../text/json_text.h"

namespace talus {

// Changes what `json` has keys for ("keys" lists all keys that are held) and keeps the rest. Returns a
// sentence on what is wrong that names the key, or an empty text.
//   "frame"  whole, from 1; must be there.   "mouse"  [x, y], px, within 100 million.
//   "down"   of the button, true or false.   "grab"   whole, from 0: see Input::grab.
//   "keys"   a list of "left", "right" and "jump".
std::string take_input_entry(const Json& json, RecordedInput& entry);

// Reads recorded input, one such entry on each line, in order. A missing key keeps its value. Lines may be
// empty; frames must not go backwards. Errors name the line.
FormatResult<std::vector<RecordedInput>> read_input_lines(std::string_view text);

// Returns the entry without the values that are the same as in the one before.
Json input_entry(const RecordedInput& entry, const RecordedInput& before);

}  // namespace talus
