/* Talus from C, and from every language that can call C: loads a level or a cart and runs its physics, which
   give the same doubles as the editor and `talus sim`.

       char error[200];
       talus_game* game = talus_open("cave.talus.json", error, sizeof error);
       if (!game) fail(error);
       talus_step(game, TALUS_RIGHT | TALUS_JUMP, 0, 0, 0);

   C99. All lengths are px of the level with y down; velocities are px a frame. Games share nothing: each may
   be used by another thread, but one by only one thread at a time. No function throws. Where one takes a
   game, null is allowed, and gets what its comment says.

   For LuaJIT's ffi.cdef take out what is from an #ifdef to its #endif, and then all lines that begin
   with #. */
#ifndef TALUS_H
#define TALUS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A level that runs. */
typedef struct talus_game talus_game;

/* Keys of the players, to be added up. */
enum { TALUS_LEFT = 1, TALUS_RIGHT = 2, TALUS_JUMP = 4 };

/* A body of the current frame. */
typedef struct talus_body {
  int32_t id;          /* from 1, in the order of the map's ball tiles, columns from the left, then spawns */
  int32_t kind;        /* from 0; see talus_kind_word() */
  int32_t is_grounded; /* 1: it stood on ground after the last frame; solver `exact` alone, else 0 */
  int32_t is_held;     /* 1: the mouse holds it; else 0 */
  double x;            /* px, left side of its box */
  double y;            /* px, top side of its box */
  double w;            /* px, width of its box */
  double h;            /* px, height of its box */
  double vx;           /* px a frame, to the right */
  double vy;           /* px a frame, down */
  double mass;         /* over 0; where bodies meet: 1 for a ball of 8x8 px */
  double radius;       /* px, of a circle on the middle of its bottom, where bodies meet; 0: a box */
  double spin;         /* px a frame, of the rim of such a circle, clockwise; else 0 */
  double turn;         /* radians, 0 up to a whole turn: how far it is turned, clockwise; else 0 */
} talus_body;

/* Something that happened in the last frame. */
typedef struct talus_event {
  int32_t kind;   /* TALUS_EVENT_HIT, TALUS_EVENT_LANDED or TALUS_EVENT_LEFT */
  int32_t body;   /* id of the body that it happened to */
  int32_t other;  /* of a hit: id of the body that it hit, 0 for the ground; else 0 */
  double nx;      /* of a hit: its normal, out of what was hit, of length 1; else 0 */
  double ny;      /* the same, down */
  double impulse; /* of a hit: mass times px a frame, along the normal, over 0; else 0 */
} talus_event;

/* Kinds of events. */
enum {
  TALUS_EVENT_HIT = 0,    /* it was stopped or thrown back, faster than gravity or its keys change its speed
                             in two frames */
  TALUS_EVENT_LANDED = 1, /* it stands, and did not after the frame before */
  TALUS_EVENT_LEFT = 2    /* it stands no longer */
};

/* Loads a level or cart of any format that the editor opens, at its first frame. Tilesets that a map names
   are read wherever they lie, as a game opens its own maps. Null after an error; then `error` holds
   "FILE:PLACE: error: MESSAGE", cut off after error_size - 1 bytes, and else "". `error` may be null. A null
   `path` is an error. */
talus_game* talus_open(const char* path, char* error, size_t error_size);

/* The same for what a file holds, `size` bytes; more than 96 MiB are an error, as they are in a file. `name`:
   of the file, whose extension may tell its format; null for none. Null `bytes` are an error unless `size` is
   0. */
talus_game* talus_read(const void* bytes, size_t size, const char* name, char* error, size_t error_size);

/* Frees a game. Null: does nothing. */
void talus_close(talus_game* game);

/* Goes one frame further. keys: what is held down, 0 for none; other bits than the three are ignored.
   mouse_down: not 0 while the left button is held, which takes the body under the mouse, drags it, and throws
   it when it is let go. A mouse that is nowhere, infinite or no number, has its button up. A level that is a
   hard case plays its own input besides. 1; 0 if the game is null or the memory does not suffice, and then
   nothing has changed. */
int talus_step(talus_game* game, uint32_t keys, double mouse_x, double mouse_y, int mouse_down);

/* Goes back to the first frame. 1; 0 if the game is null or the memory does not suffice, and then nothing has
   changed. */
int talus_restart(talus_game* game);

/* Frames that were stepped, from 0. Null: -1. */
int64_t talus_frame(const talus_game* game);

/* Width of a tile of the level's map, px, 1..256. Null: 0. */
int32_t talus_tile_width(const talus_game* game);
/* Height of a tile of the level's map, px, 1..256. Null: 0. */
int32_t talus_tile_height(const talus_game* game);

/* How many bodies there are; it does not change. Null: 0. */
int32_t talus_body_count(const talus_game* game);

/* The body at an index from 0, by id, into *body. 1; 0 if the game or `body` is null or there is no such
   body, and then nothing is written. */
int talus_body_at(const talus_game* game, int32_t index, talus_body* body);

/* How many events the last frame had; 0 before the first one and after going back to it. Only the solver
   `exact` finds any. Null: 0. */
int32_t talus_event_count(const talus_game* game);
/* The event at an index from 0, in the order in which they happened to a body, into *event. 1; 0 if the game
   or `event` is null or there is no such event, and then nothing is written. */
int talus_event_at(const talus_game* game, int32_t index, talus_event* event);

/* The word of a kind of bodies, as files have it: "ball", "player". Compare words: another version of the
   library may number kinds otherwise. The text stays valid. Null: there is no such kind. */
const char* talus_kind_word(int32_t kind);

/* A number of the frame and all bits of all bodies, which `talus sim --hash` prints in hexadecimal: equal for
   equal games on every machine. Null: 0. */
uint64_t talus_hash(const talus_game* game);

/* The floor that a box would stand on, straight below it and at most `reach` px away: 1, and *floor_y is its
   height, px. 0 where there is none, where the box is inside of the ground, and for a null game, numbers that
   are infinite or none or over 1e12, a box without a size or larger than 1024 px, a negative reach or a lack
   of memory: then *floor_y is as it was. `floor_y` may be null. The first call for a level of another solver
   than `exact` compiles the ground. */
int talus_floor(talus_game* game, double x, double y, double w, double h, double reach, double* floor_y);

#ifdef __cplusplus
}
#endif

#endif
