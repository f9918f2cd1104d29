// Turns SDL's keys into those of the editor.
#include "sdl_keys.h"

#include <array>

namespace talus {
namespace {

struct Row {
  int key;
  SDL_Keycode sdl;
};
constexpr std::array<Row, 13> kRows = {{{kKeyTab, SDLK_TAB},
                                        {kKeyDelete, SDLK_DELETE},
                                        {kKeyEscape, SDLK_ESCAPE},
                                        {kKeyHome, SDLK_HOME},
                                        {kKeyEnd, SDLK_END},
                                        {kKeyPageUp, SDLK_PAGEUP},
                                        {kKeyPageDown, SDLK_PAGEDOWN},
                                        {kKeyLeft, SDLK_LEFT},
                                        {kKeyRight, SDLK_RIGHT},
                                        {kKeyUp, SDLK_UP},
                                        {kKeyDown, SDLK_DOWN},
                                        {kKeyEnter, SDLK_RETURN},
                                        {kKeyBackspace, SDLK_BACKSPACE}}};

int key_of(SDL_Keycode sdl) {
  for (const Row& row : kRows)
    if (row.sdl == sdl) return row.key;
  if (sdl == SDLK_KP_ENTER) return kKeyEnter;
  if (sdl >= SDLK_F1 && sdl <= SDLK_F12) return kKeyF1 + (sdl - SDLK_F1);
  return sdl >= ' ' && sdl < 127 ? sdl : static_cast<int>(kNoKey);
}

SDL_Keycode sdl_of(int key) {
  for (const Row& row : kRows)
    if (row.key == key) return row.sdl;
  return key >= kKeyF1 && key <= kKeyF12 ? SDLK_F1 + (key - kKeyF1) : key;
}

}  // namespace

KeyChord chord_of(const SDL_Keysym& sym) {
  return {key_of(sym.sym), (sym.mod & KMOD_CTRL) != 0, (sym.mod & KMOD_SHIFT) != 0,
          (sym.mod & KMOD_ALT) != 0};
}

SDL_Keysym keysym_of(const KeyChord& chord) {
  SDL_Keysym sym{};
  sym.sym = sdl_of(chord.key);
  sym.scancode = SDL_GetScancodeFromKey(sym.sym);
  sym.mod = static_cast<Uint16>((chord.ctrl ? KMOD_LCTRL : 0) | (chord.shift ? KMOD_LSHIFT : 0) |
                                (chord.alt ? KMOD_LALT : 0));
  return sym;
}

}  // namespace talus
