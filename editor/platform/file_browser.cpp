// A list of folders and of the files with an ending that is asked for, and a field for the name.
#include "file_browser.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "panels/ui/dialog.h"
#include "panels/ui/long_list.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTitle = "Files";

// Selects the name in the field that was drawn last and has the keys, also while the mouse is still down and
// moves.
void select_whole_name() {
  ImGuiInputTextState* state = ImGui::GetInputTextState(ImGui::GetItemID());
  if (state == nullptr) return;
  state->SelectAll();
  state->SelectedAllMouseLock = true;
}

bool comes_before(const std::string& a, const std::string& b) {
  return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(),
      [](unsigned char x, unsigned char y) { return std::tolower(x) < std::tolower(y); });
}

}  // namespace

std::optional<FileBrowser::Answer> FileBrowser::draw(const std::optional<FileRequest>& request,
                                                     DialogTest wanted, const Session& session, Ui& ui) {
  if (request && (!shown_ || request->dialog != request_.dialog)) start(*request);
  shown_ = request.has_value();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const ImVec2 size{std::min(ui.px(640), window.x - ui.px(64)), std::min(ui.px(460), window.y - ui.px(64))};
  if (!begin_dialog(kTitle, std::move(wanted), size, session, ui)) return std::nullopt;
  draw_place(ui);
  const float below = 2 * ui.px(theme::kButton) + 2 * ImGui::GetTextLineHeightWithSpacing() + ui.px(16);
  std::optional<Answer> answer = draw_list(ui, -below);
  if (auto named = draw_name(ui)) answer = named;
  ImGui::EndPopup();
  return answer;
}

bool FileBrowser::lists(const std::string& name) const {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(request_.endings.begin(), request_.endings.end(),
                     [&](const std::string& ending) { return lower.ends_with("." + ending); });
}

std::string FileBrowser::known_endings() const {
  std::string text;
  for (const std::string& ending : request_.endings) text += (text.empty() ? "." : "  .") + ending;
  return text;
}

void FileBrowser::start(const FileRequest& request) {
  request_ = request;
  std::error_code error;
  const fs::path near(request.near);
  fs::path beside = near.parent_path();
  // A folder that is made later is part of the name.
  while (request.names_new() && beside.has_relative_path() && !fs::exists(beside, error))
    beside = beside.parent_path();
  if (!request.near.empty() && fs::is_directory(beside, error)) folder_ = beside.string();
  if (folder_.empty() || !fs::is_directory(folder_, error)) folder_ = fs::current_path(error).string();
  name_ = request.names_new() ? near.lexically_relative(beside).generic_string() : "";
  if (beside.empty() && request.names_new()) name_ = request.near;
  if (request.names_new() && name_.empty()) name_ = "level" + request.ending;
  const std::string name = name_;
  enter(folder_);
  name_ = name;
  is_name_proposed_ = request.names_new();
}

void FileBrowser::enter(const std::string& folder) {
  std::error_code error;
  std::vector<Entry> entries;
  fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  if (error) {
    error_ = "Cannot open the folder " + folder + ": " + error.message() + ".";
    return;
  }
  for (; it != fs::directory_iterator(); it.increment(error)) {
    std::error_code ignored;
    Entry entry{it->path().filename().string(), it->is_directory(ignored)};
    const bool hidden = entry.name.starts_with('.');
    if (!hidden && (entry.is_folder || lists(entry.name))) entries.push_back(std::move(entry));
    if (error) break;
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : comes_before(a.name, b.name);
  });
  folder_ = fs::weakly_canonical(folder, error).string();
  entries_ = std::move(entries);
  if (fs::path(folder_).has_relative_path()) entries_.insert(entries_.begin(), {"..", true});
  chosen_ = -1;
  error_.clear();
  overwrite_.clear();
  name_.clear();
}

void FileBrowser::draw_place(Ui& ui) {
  ui.heading(request_.title);
  ImGui::PushTextWrapPos(0);
  draw_text(folder_);
  ImGui::PopTextWrapPos();
}

std::optional<FileBrowser::Answer> FileBrowser::draw_list(Ui& ui, float height) {
  std::optional<Answer> answer;
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);
  ImGui::BeginChild("entries", {0, height}, true, ImGuiWindowFlags_NavFlattened);
  std::string entered;
  if (std::exchange(scroll_to_choice_, false)) scroll_to_row(chosen_);
  draw_rows(static_cast<int>(entries_.size()), [&](int row) {
    const auto i = static_cast<std::size_t>(row);
    const Entry& entry = entries_[i];
    const std::string label = entry.name + (entry.is_folder ? "/" : "");
    const bool chosen = static_cast<int>(i) == chosen_;
    if (selectable(label, std::to_string(i), chosen, ImGuiSelectableFlags_AllowDoubleClick)) {
      chosen_ = static_cast<int>(i);
      error_.clear();
      if (entry.is_folder)
        entered = entry.name;
      else
        name_ = entry.name;
      if (!entry.is_folder && ImGui::IsMouseDoubleClicked(0)) answer = confirm();
    }
    ui.item("files/entry/" + entry.name);
  });
  if (entries_.size() <= 1)
    ui.hint(request_.names_folder()
                ? "There is no folder here. The one that you name below will be created."
                : "There is no folder and no readable file here. Known extensions: " + known_endings());
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (!entered.empty()) {
    const std::string kept = request_.names_new() ? name_ : "";
    enter((fs::path(folder_) / entered).string());
    name_ = kept;
  }
  return answer;
}

std::optional<FileBrowser::Answer> FileBrowser::draw_name(Ui& ui) {
  std::optional<Answer> answer;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (input_text("name", "name of the file, or a path", name_, ImGuiInputTextFlags_AutoSelectAll))
    overwrite_.clear();
  if (ImGui::IsItemClicked() && std::exchange(is_name_proposed_, false)) select_whole_name();
  ui.item("files/name", "The file's name; a folder's name enters the folder.");
  const bool goes_through_list = ImGui::IsItemActive() || !ImGui::GetIO().NavVisible;
  if (goes_through_list && key_pressed(ImGuiKey_DownArrow)) move_choice(1);
  if (goes_through_list && key_pressed(ImGuiKey_UpArrow)) move_choice(-1);
  const float width = ui.px(112);
  const bool saves = request_.purpose == FileRequest::Purpose::saves;
  const char* label = !overwrite_.empty()    ? "Replace it"
                      : saves                ? "Save"
                      : request_.names_new() ? "Choose"
                                             : "Open";
  const char* help = saves                  ? "Saves under this name."
                     : request_.names_new() ? "Takes this name."
                                            : "Opens this file.";
  const DialogButton does{.widget = "files/confirm",
                          .label = label,
                          .help = help,
                          .letter = label[0],
                          .is_default = true,
                          .enabled = !name_.empty(),
                          .width = width};
  if (dialog_button(does, ui)) answer = confirm();
  ImGui::SameLine();
  const DialogButton cancel{.widget = "files/cancel",
                            .label = "Cancel",
                            .help = "Goes back to the level.",
                            .letter = label[0] == 'C' ? 'a' : 'C',
                            .is_cancel = true,
                            .width = width};
  if (dialog_button(cancel, ui)) answer = Answer{true, {}};
  const bool warns = !error_.empty() || !overwrite_.empty();
  const std::string text = !error_.empty() ? error_
                           : !overwrite_.empty()
                               ? fs::path(overwrite_).filename().string() + " exists already."
                           : request_.names_folder() ? "The name of a folder; a click in the list enters one."
                                                     : "Endings: " + known_endings();
  ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(warns ? theme::kWarning : theme::kMuted));
  ImGui::PushTextWrapPos(0);
  draw_text(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  return answer;
}

void FileBrowser::move_choice(int step) {
  if (entries_.empty()) return;
  chosen_ = std::clamp(chosen_ + step, 0, static_cast<int>(entries_.size()) - 1);
  name_ = entries_[static_cast<std::size_t>(chosen_)].name;
  scroll_to_choice_ = true;
}

std::optional<FileBrowser::Answer> FileBrowser::confirm() {
  error_.clear();
  std::error_code ignored;
  fs::path path = fs::path(folder_) / name_;
  if (request_.names_folder()) return Answer{false, path.string()};
  if (fs::is_directory(path, ignored)) {
    enter(path.string());
    return std::nullopt;
  }
  if (!request_.names_new()) return Answer{false, path.string()};
  if (!path.has_extension()) path += request_.ending;
  if (request_.purpose == FileRequest::Purpose::names) return Answer{false, path.string()};
  if (fs::exists(path, ignored) && overwrite_ != path.string()) {
    overwrite_ = path.string();
    return std::nullopt;
  }
  return Answer{false, path.string()};
}

}  // namespace talus
