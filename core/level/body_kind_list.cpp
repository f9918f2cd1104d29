// The rows of the body kinds.
#include <talus/level/body_kind.h>

namespace talus {

std::span<const BodyTraits> body_kinds() {
  static constexpr BodyTraits kKinds[] = {
      {.word = "ball",
       .help = "A ball falls and bounces.",
       .role = TileRole::ball,
       .ldtk_identifier = "Ball",
       .ldtk_color = "#FFCD75",
       .svg_color = "#ffffff"},
      {.word = "player",
       .help = "A player runs and jumps by the keys, with the exact solver.",
       .rule = BodyRule::run,
       .takes_keys = true,
       .foot = Foot::centre,
       .look = BodyLook::figure,
       .ldtk_identifier = "Player",
       .ldtk_color = "#EF7D57",
       .svg_color = "#ff4040"},
      {.word = "crate",
       .help = "A crate falls like a ball. With bodies that meet it slides, stacks and is pushed.",
       .friction = 0.5,
       .bounce = 0.1,
       .look = BodyLook::crate,
       .ldtk_identifier = "Crate",
       .ldtk_color = "#A0703C",
       .svg_color = "#a0703c"},
      {.word = "disc",
       .help = "A disc falls like a ball. With bodies that meet it is round and rolls.",
       .shape = BodyShape::circle,
       .friction = 0.5,
       .bounce = 0.3,
       .look = BodyLook::wheel,
       .ldtk_identifier = "Disc",
       .ldtk_color = "#41A6F6",
       .svg_color = "#41a6f6"},
      {.word = "marble",
       .help = "A marble falls and bounces like a ball. With bodies that meet it is round.",
       .shape = BodyShape::circle,
       .look = BodyLook::marble,
       .ldtk_identifier = "Marble",
       .ldtk_color = "#73EFF7",
       .svg_color = "#73eff7"},
  };
  return kKinds;
}

}  // namespace talus
