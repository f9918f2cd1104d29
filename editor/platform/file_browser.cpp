// A list of folders and of the files with an ending that is asked for, and a field for the name.
#include "file_browser.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "file_picture.h"
#include "formats/files/real_path.h"
#include "panels/files/picture_in_list.h"
#include "panels/ui/dialog.h"
#include "panels/ui/long_list.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTitle = "Files";
constexpr float kPlaces = 168;  // px at scale 1, of the column of folders

// Selects the name in the field that was drawn last and has the keys, also while the mouse is still down and
// moves.
void select_whole_name() {
  ImGuiInputTextState* state = ImGui::GetInputTextState(ImGui::GetItemID());
  if (state == nullptr) return;
  state->SelectAll();
  state->SelectedAllMouseLock = true;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool holds_word(const std::string& name, const std::string& part) {
  return lower_case(name).find(lower_case(part)) != std::string::npos;
}

// Of the files that were open last, each folder once.
std::vector<std::string> recent_folders(const std::vector<std::string>& files) {
  std::vector<std::string> folders;
  for (const std::string& file : files) {
    std::string folder = fs::path(file).parent_path().string();
    if (!folder.empty() && std::find(folders.begin(), folders.end(), folder) == folders.end())
      folders.push_back(std::move(folder));
  }
  return folders;
}

// A field that has the keys keeps its own text: the name of the entry that a key has chosen is put into it.
int replace_by_choice(ImGuiInputTextCallbackData* data) {
  const auto& name = *static_cast<const std::optional<std::string>*>(data->UserData);
  if (!name) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, name->c_str());
  return 0;
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
  ui.heading(request_.title);
  const float below = 2 * ui.px(theme::kButton) + 2 * ImGui::GetTextLineHeightWithSpacing() + ui.px(16);
  const float places = std::floor(std::min(ui.px(kPlaces), ImGui::GetContentRegionAvail().x / 3));
  draw_places(ui, {places, -below});
  ImGui::SameLine();
  ImGui::BeginGroup();
  draw_short_text(folder_, ImGui::GetContentRegionAvail().x, theme::tone(theme::kText));
  ui.item("files/folder", folder_);
  // The room of the picture is kept, so that no row moves from under the mouse between two clicks.
  const float beside = request_.names_new() ? 1 : std::floor(ImGui::GetContentRegionAvail().x * 0.4f);
  std::optional<Answer> answer = draw_list(ui, {-beside, -below});
  if (!request_.names_new()) {
    ImGui::SameLine();
    draw_picture(ui);
  }
  ImGui::EndGroup();
  if (auto named = draw_name(ui)) answer = named;
  ImGui::EndPopup();
  return answer;
}

void FileBrowser::draw_picture(Ui& ui) {
  const auto picture = picture_of_choice(ui);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ImGui::GetContentRegionAvail().x;
  const ImVec2 end{at.x + side, at.y + std::floor(side * 9 / 16)};
  if (picture == nullptr) {
    ui.hint("A level or a picture that is chosen is seen here.");
    return;
  }
  draw_picture_in(picture, at, end, ui);
  ui.place("files/picture", at, end);
}

bool FileBrowser::lists(const std::string& name) const {
  const std::string lower = lower_case(name);
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
  filter_.clear();
}

void FileBrowser::go_to(const std::string& folder) {
  const std::string kept = request_.names_new() ? name_ : "";
  enter(folder);
  name_ = kept;
  wants_name_ = true;
}

void FileBrowser::draw_places(Ui& ui, ImVec2 size) {
  std::vector<std::string>& kept = ui.view.files.kept_folders;
  const auto found = std::find(kept.begin(), kept.end(), folder_);
  const bool is_kept = found != kept.end();
  std::string entered;
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);
  ImGui::BeginChild("places", size, true, ImGuiWindowFlags_NavFlattened);
  const auto place = [&](const std::string& folder, std::string_view name, const std::string& widget) {
    if (selectable(name, widget, folder == folder_)) entered = folder;
    ui.item(widget, folder);
  };
  if (ui.text_button("files/keep_folder", is_kept ? "Forget this folder" : "Keep this folder", is_kept,
                     "Keeps the folder in this list, or takes it out.", {},
                     is_kept || kept.size() < kMaxKeptFolders, ImGui::GetContentRegionAvail().x)) {
    if (is_kept)
      kept.erase(found);
    else
      kept.push_back(folder_);
  }
  for (std::size_t i = 0; i < kept.size(); ++i)
    place(kept[i], last_name(kept[i]), "files/kept" + std::to_string(i));
  if (const char* const home = std::getenv("HOME"); home != nullptr) place(home, "Home", "files/home");
  const std::vector<std::string> recent = recent_folders(ui.view.files.recent_files);
  if (!recent.empty()) ui.heading("Recent");
  for (std::size_t i = 0; i < recent.size(); ++i)
    place(recent[i], last_name(recent[i]), "files/recent" + std::to_string(i));
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (!entered.empty()) go_to(entered);
}

std::vector<int> FileBrowser::listed_entries() const {
  const bool is_path = filter_.find('/') != filter_.npos;
  std::vector<int> listed;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (is_path || filter_.empty() || holds_word(entries_[i].name, filter_))
      listed.push_back(static_cast<int>(i));
  return listed;
}

// Pictures are small enough to be read at once, or are not shown.
std::shared_ptr<const SheetPicture> FileBrowser::picture_of_choice(const Ui& ui) {
  if (chosen_ < 0) return nullptr;
  const std::string path = (fs::path(folder_) / entries_[static_cast<std::size_t>(chosen_)].name).string();
  const auto& recent = ui.view.files.recent_pictures;
  if (const auto known = recent.find(path); known != recent.end()) return known->second;
  if (pictured_ != path) {
    pictured_ = path;
    picture_ = picture_in_file(path);
  }
  return picture_;
}

std::optional<FileBrowser::Answer> FileBrowser::draw_list(Ui& ui, ImVec2 size) {
  std::optional<Answer> answer;
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);
  ImGui::BeginChild("entries", size, true, ImGuiWindowFlags_NavFlattened);
  std::string entered;
  const std::vector<int> listed = listed_entries();
  const auto row_of_choice = std::find(listed.begin(), listed.end(), chosen_) - listed.begin();
  if (std::exchange(scroll_to_choice_, false)) scroll_to_row(static_cast<int>(row_of_choice));
  draw_rows(static_cast<int>(listed.size()), [&](int row) {
    const int i = listed[static_cast<std::size_t>(row)];
    const Entry& entry = entries_[static_cast<std::size_t>(i)];
    const std::string label = entry.name + (entry.is_folder ? "/" : "");
    if (selectable(label, std::to_string(i), i == chosen_, ImGuiSelectableFlags_AllowDoubleClick)) {
      chosen_ = i;
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
  else if (listed.empty())
    ui.hint("Nothing here is called so.");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (!entered.empty()) go_to((fs::path(folder_) / entered).string());
  return answer;
}

std::optional<FileBrowser::Answer> FileBrowser::draw_name(Ui& ui) {
  std::optional<Answer> answer;
  if (std::exchange(wants_name_, false) || ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const char* const asked =
      request_.names_new() ? "name of the file, or a path" : "part of a name, or a path";
  const bool is_typed = !chosen_name_;
  if (input_text("name", asked, name_, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackAlways,
                 replace_by_choice, &chosen_name_)) {
    overwrite_.clear();
    if (is_typed) {
      filter_ = request_.names_new() ? "" : name_;
      chosen_ = -1;
    }
  }
  chosen_name_.reset();
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
  const std::vector<int> listed = listed_entries();
  if (listed.empty()) return;
  const auto now = std::find(listed.begin(), listed.end(), chosen_);
  const std::ptrdiff_t row =
      now == listed.end() ? (step > 0 ? -1 : std::ssize(listed)) : now - listed.begin();
  chosen_ =
      listed[static_cast<std::size_t>(std::clamp(row + step, std::ptrdiff_t{0}, std::ssize(listed) - 1))];
  name_ = entries_[static_cast<std::size_t>(chosen_)].name;
  chosen_name_ = name_;
  scroll_to_choice_ = true;
}

std::optional<FileBrowser::Answer> FileBrowser::confirm() {
  error_.clear();
  std::error_code ignored;
  fs::path path = fs::path(folder_) / name_;
  // A part of a name is enough where only one entry holds it.
  if (const std::vector<int> listed = listed_entries();
      !request_.names_new() && listed.size() == 1 && !fs::exists(path, ignored))
    path = fs::path(folder_) / entries_[static_cast<std::size_t>(listed.front())].name;
  if (request_.names_folder()) return Answer{false, path.string()};
  if (fs::is_directory(path, ignored)) {
    enter(path.string());
    return std::nullopt;
  }
  const bool is_part = !filter_.empty() && filter_.find('/') == filter_.npos;
  if (!request_.names_new() && is_part && !fs::exists(path, ignored)) {
    const std::size_t count = listed_entries().size();
    error_ = count == 0
                 ? "Nothing here is called so."
                 : std::to_string(count) + " names hold this: go on typing, or choose one by the arrows.";
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
