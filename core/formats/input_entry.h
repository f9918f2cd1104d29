// What is held in a frame, as JSON: {"frame":8,"mouse":[x,y],"down":true,"grab":2,"keys":["left","jump"]}.
#pragma once

#include "../level/recording.h"
#include "json_text.h"

namespace talus {

// Changes what `json` has keys for ("keys" lists all that are held) and keeps the rest. Returns what is
// wrong, as a sentence that names the key, or an empty text.
//   "frame"  whole, from 1; must be there.   "mouse"  [x, y], px, within 100 million.
//   "down"   of the button, true or false.   "grab"   whole, from 0: see Input::grab.
//   "keys"   a list of "left", "right" and "jump".
std::string take_input_entry(const Json& json, RecordedInput& entry);

// The entry, without what is as in the one before.
Json input_entry(const RecordedInput& entry, const RecordedInput& before);

}  // namespace talus
