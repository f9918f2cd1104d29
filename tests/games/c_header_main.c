/* A game that uses an exported header. It reads points of its level from standard input, as lines "X Y" in 24.8 fixed
   point, and prints the floor below each. Then it prints what the tables hold for the map's last cell. */
#include "cave.h"

#include <stdio.h>

int main(void) {
  int x, y;
  const uint8_t tile = cave_map[CAVE_HEIGHT - 1][CAVE_WIDTH - 1];
  printf("%d %d %d %d\n", tile, cave_flags[tile], cave_sprite_flags[255], (int)cave_floors[cave_shapes[cave_shape_of[tile]].row][0]);
  for (int i = 0; i <= CAVE_BODIES; ++i) {
    const cave_body *body = &cave_bodies[i];
    printf("%s %s %d %d %d %d\n", body->name, body->kind, (int)body->tile, (int)body->stands_on_centre,
           (int)body->x, (int)body->y);
  }
  printf("%s %.17g %.17g %.17g\n", CAVE_SOLVER, CAVE_TUNING_FALL_BLEND, CAVE_TUNING_EXACT_GRAVITY,
         CAVE_TUNING_PLAYER_JUMP_SPEED);
  while (scanf("%d %d", &x, &y) == 2) printf("%ld\n", (long)cave_floor_below(x, y));
  return 0;
}
