/* Plays a level through the interface for C:
     c_play FILE FRAMES            prints each body after each frame, "frame id x y vx vy", and the last frame's hash
     c_play --checks FILE BAD      checks what talus.h says about bad values. FILE: a level whose body 1 is a ball over
                                   ground. BAD: a file that is no level. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <talus/c/talus.h>

static void must(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "does not hold: %s\n", what);
  exit(1);
}
#define MUST(condition) must(condition, #condition)

static int play(const char* path, int frames) {
  char error[500];
  talus_game* game = talus_open(path, error, sizeof error);
  talus_body body;
  int32_t i;
  if (!game) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  while (talus_frame(game) < frames) {
    talus_step(game, 0, 0, 0, 0);
    for (i = 0; talus_body_at(game, i, &body); ++i)
      printf("%d %d %.17g %.17g %.17g %.17g\n", (int)talus_frame(game), (int)body.id, body.x, body.y, body.vx,
             body.vy);
  }
  printf("%016llx\n", (unsigned long long)talus_hash(game));
  talus_close(game);
  return 0;
}

static void check_null(void) {
  talus_body body = {7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  double floor_y = 3;
  char error[100];
  talus_close(NULL);
  MUST(talus_step(NULL, 0, 0, 0, 0) == 0);
  MUST(talus_restart(NULL) == 0);
  MUST(talus_frame(NULL) == -1);
  MUST(talus_tile_width(NULL) == 0 && talus_tile_height(NULL) == 0);
  MUST(talus_body_count(NULL) == 0);
  MUST(talus_body_at(NULL, 0, &body) == 0 && body.id == 7);
  MUST(talus_event_count(NULL) == 0);
  MUST(talus_hash(NULL) == 0);
  MUST(talus_floor(NULL, 0, 0, 8, 8, 9, &floor_y) == 0 && floor_y == 3);
  MUST(!talus_open(NULL, error, sizeof error) && strcmp(error, "error: the path is null") == 0);
  MUST(!talus_open(NULL, NULL, 10));
  MUST(!talus_read(NULL, 5, NULL, error, sizeof error) && strcmp(error, "error: the bytes are null") == 0);
  MUST(!talus_read(NULL, 0, NULL, error, sizeof error) && error[0] != '\0');
}

static void check_errors(const char* bad) {
  char error[500], start[6];
  MUST(!talus_open(bad, error, sizeof error) && strncmp(error, bad, strlen(bad)) == 0);
  MUST(strstr(error, ": error: ") != NULL);
  MUST(!talus_open(bad, start, sizeof start) && strlen(start) == 5 && strncmp(start, bad, 5) == 0);
  start[0] = 'x';
  MUST(!talus_open(bad, start, 0) && start[0] == 'x');
}

/* A map whose XML has names that mean something else in JSON. */
static void check_odd_map(void) {
  const char* const map =
      "<map orientation='orthogonal' width='1' height='1' tilewidth='8' tileheight='8' layers='x'><layers/>"
      "<tilesets/><layer name='l'><data encoding='csv'>0</data></layer></map>";
  char error[100];
  talus_game* game = talus_read(map, strlen(map), "odd.tmx", error, sizeof error);
  MUST(game && error[0] == '\0' && talus_body_count(game) == 0);
  talus_close(game);
  MUST(!talus_read("{}\n::error::", 12, "a\n.talus.json", error, sizeof error) && !strchr(error, '\n'));
}

/* Checks what the mouse does to the first body, which is a ball. */
static void check_mouse(talus_game* game) {
  talus_body start, body;
  MUST(talus_body_at(game, 0, &start));
  MUST(start.id == 1 && !strcmp(talus_kind_word(start.kind), "ball") && start.is_held == 0 && start.w == 8 && start.h == 8);
  talus_step(game, 8, start.x + 4, start.y + 4, 1);
  MUST(talus_body_at(game, 0, &body) && body.is_held == 1);
  talus_step(game, 0, start.x + 54, start.y + 4, 1);
  MUST(talus_body_at(game, 0, &body) && body.x > start.x + 5);
  talus_step(game, 0, NAN, start.y + 4, 1);
  MUST(talus_body_at(game, 0, &body) && body.is_held == 0);
  MUST(talus_restart(game) == 1 && talus_frame(game) == 0);
  MUST(talus_body_at(game, 0, &body) && memcmp(&body, &start, sizeof body) == 0);
}

/* A ball falls on a floor, and stays there. */
static void check_events(void) {
  const char* const level =
      "{\"talus\": 1, \"roles\": {\"solid\": 0}, \"tiles\": {\"1\": {\"flags\": [0]}},"
      " \"map\": {\"width\": 4, \"height\": 4, \"rows\": [\"\", \"\", \"\", \"01010101\"]},"
      " \"tuning\": {\"solver\": \"exact\", \"fall_speed\": 2, \"floor_bounce\": 0},"
      " \"spawns\": [{\"name\": \"\", \"x\": 8, \"y\": 4, \"vx\": 0, \"vy\": 0}]}";
  char error[100];
  talus_game* game = talus_read(level, strlen(level), NULL, error, sizeof error);
  talus_event event = {7, 0, 0, 0, 0, 0};
  int hits = 0, landed = 0, left = 0, i;
  int32_t k;
  MUST(game && error[0] == '\0');
  MUST(talus_event_count(game) == 0 && talus_event_at(game, 0, &event) == 0 && event.kind == 7);
  for (i = 0; i < 100; ++i) {
    MUST(talus_step(game, 0, 0, 0, 0));
    for (k = 0; talus_event_at(game, k, &event); ++k) {
      MUST(event.body == 1 && event.other == 0);
      MUST(event.kind != TALUS_EVENT_HIT || (event.nx == 0 && event.ny == -1 && event.impulse > 0));
      hits += event.kind == TALUS_EVENT_HIT;
      landed += event.kind == TALUS_EVENT_LANDED;
      left += event.kind == TALUS_EVENT_LEFT;
    }
    MUST(k == talus_event_count(game));
  }
  MUST(hits == 1 && landed == 1 && left == 0);
  MUST(talus_event_at(game, -1, &event) == 0 && talus_event_at(game, 0, NULL) == 0);
  talus_close(game);
}

static void check_floor(talus_game* game) {
  talus_body body;
  double floor_y = -1;
  MUST(talus_body_at(game, 0, &body));
  MUST(talus_floor(game, body.x, body.y, body.w, body.h, 1000, &floor_y) == 1);
  MUST(floor_y >= body.y + body.h);
  MUST(talus_floor(game, body.x, body.y, body.w, body.h, 1000, NULL) == 1);
  MUST(talus_floor(game, body.x, body.y, body.w, body.h, floor_y - body.y - body.h - 1, &floor_y) == 0);
  floor_y = -1;
  MUST(talus_floor(game, NAN, body.y, 8, 8, 1000, &floor_y) == 0);
  MUST(talus_floor(game, body.x, body.y, 0, 8, 1000, &floor_y) == 0);
  MUST(talus_floor(game, body.x, body.y, 8, 1025, 1000, &floor_y) == 0);
  MUST(talus_floor(game, body.x, body.y, 8, 8, -1, &floor_y) == 0);
  MUST(talus_floor(game, body.x, body.y, 8, 8, INFINITY, &floor_y) == 0);
  MUST(floor_y == -1);
}

static void check_bodies(talus_game* game) {
  talus_body body = {7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  const int32_t count = talus_body_count(game);
  MUST(count > 0);
  MUST(talus_body_at(game, count, &body) == 0 && talus_body_at(game, -1, &body) == 0 && body.id == 7);
  MUST(talus_body_at(game, 0, NULL) == 0);
  MUST(talus_body_at(game, count - 1, &body) == 1 && body.id == count);
}

/* The same level from its bytes. */
static void check_bytes(const char* path, const talus_game* game) {
  static char bytes[1 << 22];
  char error[100];
  FILE* file = fopen(path, "rb");
  const size_t size = file ? fread(bytes, 1, sizeof bytes, file) : 0;
  talus_game* again = talus_read(bytes, size, path, error, sizeof error);
  MUST(size > 0 && again && error[0] == '\0');
  MUST(talus_hash(again) == talus_hash(game));
  MUST(talus_step(again, 0, 0, 0, 0) == 1 && talus_frame(again) == 1);
  MUST(talus_hash(again) != talus_hash(game));
  talus_close(again);
  fclose(file);
}

int main(int argc, char** argv) {
  talus_game* game;
  if (argc == 3) return play(argv[1], atoi(argv[2]));
  if (argc != 4) return 2;
  check_null();
  check_errors(argv[3]);
  check_odd_map();
  check_events();
  game = talus_open(argv[2], NULL, 0);
  MUST(game != NULL);
  check_bodies(game);
  check_mouse(game);
  check_floor(game);
  check_bytes(argv[2], game);
  talus_close(game);
  printf("all checks hold\n");
  return 0;
}
