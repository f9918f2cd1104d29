// Documents in the grammar of a format: a good one, changed at places and in ways that bytes choose. Bytes
// alone rarely get past the first check of a reader; these get as far as the wrong value in the right place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

// What the bytes of a fuzzer, or of a random generator, choose.
class RandomBytes {
 public:
  explicit RandomBytes(std::string_view bytes) : bytes_(bytes) {}
  // 0..count-1; 0, which always means that nothing is changed, when the bytes are used up. count: 1 to 255.
  unsigned below(unsigned count);
  std::size_t index(std::size_t count);  // the same for more

 private:
  std::string_view bytes_;
};

class Grammar {
 public:
  // good: a document without an error, in JSON or XML, told by its first character (asserted).
  explicit Grammar(std::string good);

  // Members, attributes and elements may be left out, given twice, or have another's name or value, the wrong
  // type, a number that nobody expects, or something nested deep in their place; a document may end early or
  // go on.
  std::string document(RandomBytes& choices) const;
  // Some documents, a line each.
  std::string lines(RandomBytes& choices) const;

 private:
  std::string good_;                 // XML without its declaration
  std::vector<std::string> names_;   // of members, attributes and elements
  std::vector<std::string> values_;  // as they are written there
};

// tests/fuzz/seeds/NAME (asserted to be there).
Grammar grammar_of_seed(const std::string& name);

}  // namespace talus
