// How a file was read, as a text, so that it can be read so again.
#pragma once

#include <string>
#include <string_view>

#include <talus/formats/format.h>

namespace talus {

// One object of JSON: "layer", the number of the only layer; "level", of a project; "frame", as in companions
// of maps of Tiled; "tiles" and "mapping", as in those of LDtk. What is as usual is left out, and so are
// permissions and the choices for a first reading.
std::string text_of_choices(const ImportChoices& choices);
// The same read again. What is not as above is left out.
ImportChoices choices_in(std::string_view text);

}  // namespace talus
