/* A game's use of an exported header: prints the floor below points of its level, which it reads from standard
   input as "X Y" in 24.8 fixed point, one a line; and what the tables hold of the map's last cell. */
#include "cave.h"

#include <stdio.h>

int main(void) {
  int x, y;
  const uint8_t tile = cave_map[CAVE_HEIGHT - 1][CAVE_WIDTH - 1];
  printf("%d %d %d %d\n", tile, cave_flags[tile], cave_sprite_flags[255], (int)cave_floors[cave_shapes[cave_shape_of[tile]].row][0]);
  printf("%d %s %d\n", CAVE_SPAWNS, cave_spawns[0].name, (int)cave_spawns[0].x);
  while (scanf("%d %d", &x, &y) == 2) printf("%ld\n", (long)cave_floor_below(x, y));
  return 0;
}
