// World: boxes in a hashed grid, and how a moving box meets them. Reproduces bump.lua 3.1.7 bit for bit.
//
//   World world(24);
//   ItemId wall = world.add({0, 8, 64, 8});
//   ItemId ball = world.add({0, 0, 8, 8});
//   std::vector<Collision> hits;
//   Vec2 at = world.move(ball, {5, 3}, hits);           // slides along the wall; at == {5, 0}
//
// Programmer errors (a stale handle, a size of zero) throw WorldError with bump's own sentence and change
// nothing. Within one call, results are ordered as documented; ties go to the item that was added first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <talus/collision/function_ref.h>
#include <talus/collision/geometry.h>

namespace talus {

// Names an item of one World. It is a value: copy it freely. {0,0} names nothing. Once its item is removed
// the handle is stale for good, since a later item in the same slot has another generation.
struct ItemId {
  std::uint32_t index = 0;       // slot, from 1; dense, so it can index a caller's own array
  std::uint32_t generation = 0;  // from 1; 0 only in the null handle
  explicit operator bool() const { return generation != 0; }  // it names an item, present or removed
  friend bool operator==(const ItemId&, const ItemId&) = default;
};

// What a filter answers about a pair of items, and so how the mover reacts. World::add_response returns
// values from `first_user` on.
enum class Response : std::uint16_t {
  ignore,  // not a candidate: passes through, nothing reported
  touch,   // stops at the touch point
  cross,   // passes through, reported
  slide,   // goes on along the surface
  bounce,  // goes on mirrored at the surface
  first_user,
};

// One contact of a move, in the order in which the move met them.
struct Collision {
  ItemId item;                          // the mover; null when project() was called without one
  ItemId other;                         // what it met
  Response response = Response::touch;  // what the filter answered
  bool overlaps = false;                // the boxes already overlapped before the move
  double ti = 0;            // time of impact, fraction of `move`; minus the overlap area if overlaps
  Vec2 move;                // px, what the mover wanted when this contact was found
  Vec2 normal;              // unit axis vector out of `other`; {0,0} has no direction
  Vec2 touch;               // px, the mover's top-left corner at the contact
  Rect item_rect;           // px, the mover before the move
  Rect other_rect;          // px, of what it met
  std::optional<Vec2> aim;  // slide and bounce: the goal they redirected the mover to
};

// A box met by a segment. ti1 and ti2 are the fractions of the segment where it enters and leaves the box.
struct SegmentHit {
  ItemId item;     // the box's
  double ti1 = 0;  // 0..1, where it enters; 0 when it starts inside
  double ti2 = 0;  // 0..1, where it leaves; 1 when it ends inside
  Vec2 enter;      // px, point at ti1
  Vec2 leave;      // px, point at ti2
};

// Thrown by a World; its what() is a sentence in bump's words.
class WorldError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Texts of errors, for callers that keep items under names of their own. This one: no item of that name is in
// the world.
std::string item_not_added_message(std::string_view item);
// An item of that name is in the world already.
std::string item_added_twice_message(std::string_view item);
// There is no response of that name.
std::string unknown_response_message(std::string_view name);

// For one thread at a time: even the const functions share scratch memory. A filter or response may call the
// const ones, but must never change the world. A projection calls the filter once for every item whose cells
// the swept box covers, before any geometry, in an order that depends only on the calls made so far.
class World {
 public:
  using Filter = FunctionRef<Response(ItemId item, ItemId other)>;  // how `item` reacts to `other`
  using ItemFilter = FunctionRef<bool(ItemId item)>;                // true keeps the item in a query's answer

  // A filter as a table: the response to an item by its group. It gives the same results as a function that
  // looks up the group, in less than half the time: nothing is called, and what is far from the move is
  // looked at once.
  static constexpr int kGroupCount = 8;                      // groups of items
  using GroupResponses = std::array<Response, kGroupCount>;  // by group

  // How contacts are computed.
  enum class Mode {
    faithful,  // bump's results to the last bit, quirks included
    // Places the mover exactly on the side it hit: no ghosts, no sticking at seams, no teleports. An overlap
    // is left by its shortest way first. Crossed items are reported on the way actually travelled and do not
    // bend it. Solid items may be met again after a bounce; after 64 contacts the mover stays at the last.
    // Coordinates must be finite.
    robust,
  };

  // Where bump would hang or run out of memory, WorldError is thrown and nothing changes: for a coordinate
  // that is infinite, or kMaxCell cells or more from the origin; and for an item with which all items would
  // cover more than kMaxCells cells, plus kMaxCellsOfItem for each.
  static constexpr int kMaxCell = 1 << 30;             // cells from the origin
  static constexpr std::int64_t kMaxCells = 1 << 20;   // limit for all items together, besides that of each
  static constexpr std::int64_t kMaxCellsOfItem = 16;  // that each item may cover besides
  static constexpr double kMaxCellSize = 1e100;        // px; keeps squares of coordinates finite

  // cell_size: px, side of a grid cell; > 0 and at most kMaxCellSize, or WorldError. A few times a typical
  // item is a good value.
  explicit World(double cell_size = 64, Mode mode = Mode::faithful);
  ~World();
  World(World&&) noexcept;             // the other one may only be destroyed or assigned to
  World& operator=(World&&) noexcept;  // the same

  // w and h must be > 0, as for bump; NaN is accepted, as by bump, and puts the item in no cell. `group`, for
  // GroupResponses: 0 to kGroupCount - 1 (asserted). The handle is valid until the item is removed.
  ItemId add(Rect rect, int group = 0);
  // Its handle is stale from then on: every function that takes it throws WorldError, except has().
  void remove(ItemId item);
  void update(ItemId item, Rect rect);      // places it without looking for contacts
  void update(ItemId item, Vec2 position);  // the same, keeping its size

  // Moves towards the goal, px, of its top-left corner, under the filter's responses; returns where it ended,
  // px. `hits` gets the contacts in the order in which they were met, and is cleared first.
  Vec2 move(ItemId item, Vec2 goal, Filter filter, std::vector<Collision>& hits);
  // The same with a table.
  Vec2 move(ItemId item, Vec2 goal, const GroupResponses& responses, std::vector<Collision>& hits);
  Vec2 move(ItemId item, Vec2 goal, std::vector<Collision>& hits);  // the same; slide against everything
  // As move, but only says where it would end.
  Vec2 check(ItemId item, Vec2 goal, Filter filter, std::vector<Collision>& hits) const;
  // The same with a table.
  Vec2 check(ItemId item, Vec2 goal, const GroupResponses& responses, std::vector<Collision>& hits) const;
  // The same for a box that is not an item of this world, from `start`, px; the filter's `item` is null.
  Vec2 check(Rect start, Vec2 goal, Filter filter, std::vector<Collision>& hits) const;
  // The same with a table.
  Vec2 check(Rect start, Vec2 goal, const GroupResponses& responses, std::vector<Collision>& hits) const;
  // Every contact on the straight way of a box from `rect` to `goal`, by time, then distance, then age; no
  // response is run. `item` is left out of the candidates and may be null.
  void project(ItemId item, Rect rect, Vec2 goal, Filter filter, std::vector<Collision>& hits) const;

  // Queries: `out` is cleared first, and stays empty if nothing is found. A filter returns true for items to
  // keep.
  //
  // Items that strictly overlap the rectangle, px, in the order of adding.
  void query_rect(Rect rect, std::vector<ItemId>& out) const;
  // The same, but only items that the filter keeps.
  void query_rect(Rect rect, ItemFilter filter, std::vector<ItemId>& out) const;
  // Items with the point, px, inside, in the order of adding.
  void query_point(Vec2 point, std::vector<ItemId>& out) const;
  // The same, but only items that the filter keeps.
  void query_point(Vec2 point, ItemFilter filter, std::vector<ItemId>& out) const;
  // Items that the segment cuts, px, in the order from `from` to `to`.
  void query_segment(Vec2 from, Vec2 to, std::vector<SegmentHit>& out) const;
  // The same, but only items that the filter keeps.
  void query_segment(Vec2 from, Vec2 to, ItemFilter filter, std::vector<SegmentHit>& out) const;

  // Limits the cells and boxes that one check() or move() tests, roughly: each contact makes it test those
  // near again, which in a heap of thousands would take minutes. At the limit the mover stays where it is,
  // without contacts, and gave_up() returns true. In robust mode a move searches at most 64 times anyway.
  static constexpr std::int64_t kMaxTests = 1 << 26;
  void set_most_tests(std::int64_t count);  // for each check from now on; below 1 counts as 1
  bool gave_up() const noexcept;  // whether the last check() or move() gave up, also one by a response
  // The number of cells and boxes that all calls together have tested since the world was made, roughly. The
  // work of a call depends on the items alone, not on how they came to their places, nor on how a response is
  // chosen.
  std::int64_t looks() const noexcept;

  bool has(ItemId item) const noexcept;        // false for a stale or null handle
  Rect rect(ItemId item) const;                // px
  void items(std::vector<ItemId>& out) const;  // all, in the order of adding; `out` is cleared first
  std::size_t item_count() const noexcept;     // of all
  // Cells that hold or ever held an item, as bump counts them until its garbage is collected. Collected by
  // collect_empty_cells(), or when the grid must grow and most of them are empty.
  std::size_t cell_count() const noexcept;
  void collect_empty_cells();  // forgets the cells that hold no item

  double cell_size() const noexcept;  // px
  Cell to_cell(Vec2 point) const;     // 1-based, as bump's: the cell of {0,0} is {1,1}
  Vec2 to_world(Cell cell) const;     // px, its top-left corner

  // A response of the user's own. It gets the contact, the mover's box at the start of the move and its goal.
  // It appends further contacts to `next` (usually by world.project with the same filter), and returns the
  // new goal.
  using ResponseFunction = std::function<Vec2(const World& world, Collision& hit, Rect start, Vec2 goal,
                                              Filter filter, std::vector<Collision>& next)>;
  Response add_response(std::string name, ResponseFunction function);  // replaces one of the same name
  // The response of that name, built in or added; nothing if there is none.
  std::optional<Response> find_response(std::string_view name) const;
  // The name of a response that is built in or was added; WorldError for another one.
  std::string_view response_name(Response response) const;

 private:
  struct Impl;
  template <class Choice>
  class Checker;
  template <class Choice>
  Vec2 run_check(ItemId item, Rect start, Vec2 goal, Choice choice, std::vector<Collision>& hits) const;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talus
