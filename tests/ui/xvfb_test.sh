#!/usr/bin/env bash
# Runs the built editor as a real window under Xvfb and drives it with xdotool: paints, saves and quits, and
# checks that the file has changed. Argument: the program.
set -euo pipefail

program=$1
folder=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$folder"' EXIT
cat >"$folder/before.lua" <<'CART'
-- script: lua
-- <TILES>
-- 001:dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd
-- </TILES>
CART
"$program" import "$folder/before.lua" -o "$folder/before.talus.json"
cp "$folder/before.talus.json" "$folder/level.talus.json"
export TALUS_CONFIG_DIR=$folder/config TALUS_STATE_DIR=$folder/state
unset SDL_VIDEODRIVER WAYLAND_DISPLAY

fail() {
  echo "failed: $1" >&2
  exit 1
}

# Xvfb picks a free display and writes its number. -noreset: without it, Xvfb restarts whenever its only client leaves,
# as each search for a window does, and refuses the editor if it connects meanwhile.
mkfifo "$folder/display"
Xvfb -displayfd 3 -noreset -screen 0 1400x900x24 -nolisten tcp 3>"$folder/display" 2>/dev/null &
read -r display <"$folder/display" || fail "Xvfb does not start"
export DISPLAY=:$display

"$program" "$folder/level.talus.json" &
editor=$!
wait_until() {  # COMMAND...: waits as long as the editor runs; fails after ten minutes
  local i
  for i in $(seq 6000); do
    ! "$@" || return 0
    kill -0 "$editor" 2>/dev/null || return 1
    sleep 0.1
  done
  return 1
}
# The window gets the name of the file when the editor is ready. SDL may open and close another window before that.
find_window() {
  window=$(xdotool search --onlyvisible --name '^level.talus.json - Talus$' 2>/dev/null | head -n 1)
  [ -n "$window" ]
}
wait_until find_window || fail "no window appears"
xdotool windowfocus --sync "$window"

# The file is another one after each save.
number() { stat -c %i "$folder/level.talus.json"; }
is_saved() { [ "$(number)" != "$before" ]; }
save() {
  local before
  before=$(number)
  xdotool key --window 0 ctrl+s
  wait_until is_saved || fail "Ctrl+S does not save"
}
save  # from now on there are frames, which the mouse needs

# Picks a tile of the sheet's first row, then paints a fast stroke over at least six cells of the level, in the middle
# of the window.
xdotool mousemove --window "$window" 36 62 click 1
xdotool mousemove --window "$window" 440 300 mousedown 1 mousemove --window "$window" 570 300 \
  mousemove --window "$window" 700 300 mouseup 1
save
cmp -s "$folder/before.talus.json" "$folder/level.talus.json" && fail "the stroke is not in the file"
grep -q '010101010101' "$folder/level.talus.json" || fail "the stroke has lost its end"

xdotool key --window 0 ctrl+q
wait "$editor" || fail "the program ends with status $?"
[ -s "$folder/config/settings.json" ] || fail "no settings are remembered"
echo "painted, saved and quit in a real window"
