// The project of LDtk that a level came from, and what its user has said that the things in it stand for.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/level/tileset.h>

namespace talus {

struct Level;
struct PictureTiles;

// What the things in a project of LDtk stand for, where their names alone do not tell it as the user wants.
struct LdtkMapping {
  // A kind of things.
  enum class Kind : std::uint8_t { value, tag, entity };
  // A thing, and what it stands for.
  struct Choice {
    Kind kind = Kind::value;  // a value of an IntGrid, an enum tag of tiles, or a type of entities
    std::string of = {};      // the identifier of a value's layer, or of a tag's tileset; empty for entities
    std::string name = {};    // the number of a value, the name of a tag, the identifier of an entity
    // Of values and tags, a word of ldtk_shape_words(); empty: the shape that the name says.
    std::string shape = {};
    // Of values and tags, a word of ldtk_flag_words(); empty: the flag that the name says.
    std::string flag = {};
    std::string body = {};  // of entities, a word of ldtk_body_words(); empty: the body that the name says
    friend bool operator==(const Choice&, const Choice&) = default;
  };
  std::vector<Choice> choices = {};  // each thing at most once, in the order in which they were made
  // The choice for a thing; null: there is none.
  const Choice* find(Kind kind, const std::string& of, const std::string& name) const;
  // Replaces the choice for the same thing. One that says nothing is removed.
  void set(const Choice& choice);
  friend bool operator==(const LdtkMapping&, const LdtkMapping&) = default;
};

// A value, a tag or a type of entities, for the user to choose what it stands for.
struct LdtkThing {
  LdtkMapping::Choice choice = {};  // which it is; says nothing
  std::string label = {};           // on screen, printable
  std::string usual = {};           // what its name says: "solid, its own flag"
  std::optional<Rgb> color = {};    // of values and entities; nothing: unknown
  int count = 0;                    // of cells, tiles or entities in the level
};

// The level of a project that a level came from, kept so that what was added to it is known, and so that it
// can be read again. formats/ alone looks inside `tiles` and `opened`.
struct LdtkOrigin {
  std::string project = {};                  // iid of the project; empty: it has none
  std::string level = {};                    // iid of the level in it; of one without, its name
  std::string name = {};                     // of the level, "Cave", or "World/Cave"
  int layer_number = 0;                      // as in ImportChoices, when it was read
  LdtkMapping mapping = {};                  // by which it was read
  std::vector<LdtkThing> things = {};        // what the project has, and how often the level has it
  std::vector<std::string> tiles = {};       // by tile of the level, which cells of LDtk it stands for
  std::shared_ptr<const Level> opened = {};  // what the project alone gave
  std::shared_ptr<const PictureTiles> pictures = {};  // which parts of its pictures the level's tiles show
};

}  // namespace talus
