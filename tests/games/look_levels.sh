# Read by the tests of exported games that draw: calls `look LEVEL` for each level whose picture says something. They are
# written into the folder $work.
# Tile 0 with pixels, a ball with a tile, balls without one, players and a marble.
for balls in '"flags": [1], ' ''; do
  cat >"$work/looks.talus.json" <<LEVEL
{"talus": 1, "tiles": {
  "0": {"pixels": "00000000 0a000000 00000000 00000000 00000000 00000a00 00000000 00000000"},
  "1": {"flags": [0], "pixels": "dddddddd 0000000d d000000d d00aa00d d00aa00d d000000d d000000d dddddddd"},
  "2": {${balls}"pixels": "00444400 04444440 44444444 44400444 44400444 44444444 04444440 00444400"}},
 "spawns": [{"x": 40, "y": 16}, {"x": 64, "y": 12, "size": [16, 12]},
  {"kind": "player", "x": 96, "y": 16, "size": [10, 20]}, {"kind": "player", "x": 120, "y": 16, "size": [20, 20], "foot": "box"},
  {"kind": "marble", "x": 160, "y": 12, "size": [16, 12]}],
 "map": {"width": 30, "height": 17, "rows": ["", "", "..02..02", "", "", "", "0101010101"]}}
LEVEL
  look "$work/looks.talus.json"
done
look "$root/assets/demo.talus.json"

# A large tile over another one and one that its tileset turns, a picture behind the tiles, and one as an object in front.
cat >"$work/pictured.talus.json" <<LEVEL
{"talus": 6, "tiles": {"1": {"flags": [0], "pixels": "dddddddd 0000000d d000000d d00aa00d d00aa00d d000000d d000000d dddddddd"}},
 "pictures": [["iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADklEQVR4nGP4z8DwHwQBEPgD/U6VwW8AAAAASUVORK5CYII="]],
 "large_tiles": {"2": {"picture": 0, "size": [16, 12], "shift": [0, 1]},
  "3": {"picture": 0, "swaps_axes": true, "mirrors_x": true, "size": [16, 8]}},
 "render_order": "left-up",
 "objects": [{"offset": [20, 4], "place": 0, "image": {"picture": 0, "repeats_x": true}, "objects": []},
  {"opacity": 0.5, "tint": "ff8040", "objects": [{"form": "tile", "x": 64, "y": 40, "width": 24, "height": 16, "picture": 0, "mirrors_y": true}]}],
 "map": {"width": 30, "height": 17, "rows": ["", "", "..020201..03", "..010201", "", "", "0101010101"]}}
LEVEL
look "$work/pictured.talus.json"

# The same with cells that turn the large tiles, all of which differ then.
sed 's/"rows": /"turns": ["", "", ".57..3", "..1"], "rows": /' "$work/pictured.talus.json" >"$work/turned.talus.json"
look "$work/turned.talus.json"

# Layers: ground on an even back, and what is only drawn, moved, tinted, half clear and hidden.
cat >"$work/layers.talus.json" <<'LEVEL'
{"talus": 4, "tiles": {
  "1": {"flags": [0], "pixels": "dddddddd 0000000d d000000d d00aa00d d00aa00d d000000d d000000d dddddddd"},
  "2": {"flags": [1], "pixels": "00444400 04444440 44444444 44400444 44400444 44444444 04444440 00444400"}},
 "spawns": [{"kind": "player", "x": 96, "y": 16, "size": [10, 20]}],
 "map": {"width": 30, "height": 17},
 "layers": [
  {"name": "back", "ground": false, "opacity": 0.5, "tint": "ff8040", "offset": [3, -2], "rows": ["", "01010202", "01"]},
  {"name": "ground", "rows": ["", "", "..02..02", "", "", "", "0101010101"]},
  {"name": "gone", "ground": false, "visible": false, "rows": ["01010101010101010101"]},
  {"name": "front", "ground": false, "offset": [0, 4], "rows": ["", "", "", "", "", "..02..02", "..02"]}]}
LEVEL
look "$work/layers.talus.json"

# A background that is not colour 0, behind ground with pixels of colour 0 and beside it.
cat >"$work/background.talus.json" <<'LEVEL'
{"talus": 8, "background": "#204060", "tiles": {
  "1": {"flags": [0], "pixels": "dddddddd 0000000d d000000d d00aa00d d00aa00d d000000d d000000d dddddddd"}},
 "map": {"width": 30, "height": 17, "rows": ["", "", "", "..01", "0101010101"]}}
LEVEL
look "$work/background.talus.json"

# Balls that are an animated tile, which shows another one at first.
cat >"$work/animated.talus.json" <<'LEVEL'
{"talus": 1, "tiles": {
  "1": {"flags": [0], "pixels": "dddddddd 0000000d d000000d d00aa00d d00aa00d d000000d d000000d dddddddd"},
  "2": {"flags": [1]}, "3": {"pixels": "00444400 04444440 44444444 44400444 44400444 44444444 04444440 00444400"}},
 "animations": {"2": [[3, 60000]]},
 "spawns": [{"x": 40, "y": 16}],
 "map": {"width": 30, "height": 17, "rows": ["", "", "..02..02", "", "", "", "0101010101"]}}
LEVEL
look "$work/animated.talus.json"
