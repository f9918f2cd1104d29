// The list of actions. Each alternative of Action has its line at the end.
#include "actions.h"

namespace talus {

Actions::Actions() = default;
Actions::Actions(std::initializer_list<Action> actions) : list_(actions) {}
Actions::Actions(const Actions& other) = default;
Actions::Actions(Actions&& other) noexcept = default;
Actions& Actions::operator=(const Actions& other) = default;
Actions& Actions::operator=(Actions&& other) noexcept = default;
Actions::~Actions() = default;

template <class A>
void Actions::push_back(A action) {
  list_.emplace_back(std::move(action));
}

const Action* Actions::begin() const { return list_.data(); }
const Action* Actions::end() const { return list_.data() + list_.size(); }

template void Actions::push_back(Action);
template void Actions::push_back(action::EditLevel);
template void Actions::push_back(action::Undo);
template void Actions::push_back(action::Redo);
template void Actions::push_back(action::NewLevel);
template void Actions::push_back(action::OpenFile);
template void Actions::push_back(action::SaveRecording);
template void Actions::push_back(action::SaveFile);
template void Actions::push_back(action::CancelReading);
template void Actions::push_back(action::SaveFileAs);
template void Actions::push_back(action::ExportPng);
template void Actions::push_back(action::SetExportPath);
template void Actions::push_back(action::PreviewExport);
template void Actions::push_back(action::RunExports);
template void Actions::push_back(action::CancelExport);
template void Actions::push_back(action::OpenPng);
template void Actions::push_back(action::SetPngImport);
template void Actions::push_back(action::ApplyPngImport);
template void Actions::push_back(action::CancelPngImport);
template void Actions::push_back(action::SetLevelImport);
template void Actions::push_back(action::ApplyLevelImport);
template void Actions::push_back(action::CancelLevelImport);
template void Actions::push_back(action::Quit);
template void Actions::push_back(action::AnswerQuestion);
template void Actions::push_back(action::CancelSaveAs);
template void Actions::push_back(action::RecoverLevel);
template void Actions::push_back(action::CheckFile);
template void Actions::push_back(action::ShowMessage);
template void Actions::push_back(action::DismissMessage);
template void Actions::push_back(action::Play);
template void Actions::push_back(action::Pause);
template void Actions::push_back(action::TogglePlay);
template void Actions::push_back(action::StepFrame);
template void Actions::push_back(action::ResetPlay);
template void Actions::push_back(action::SetSpeed);
template void Actions::push_back(action::HoldMouse);
template void Actions::push_back(action::HoldKeys);
template void Actions::push_back(action::StepBack);
template void Actions::push_back(action::SeekStart);
template void Actions::push_back(action::SeekEnd);
template void Actions::push_back(action::SeekFrame);
template void Actions::push_back(action::SetMark);
template void Actions::push_back(action::RemoveMark);
template void Actions::push_back(action::JumpToMark);
template void Actions::push_back(action::TakeOver);
template void Actions::push_back(action::SwitchBranch);
template void Actions::push_back(action::DropBranch);
template void Actions::push_back(action::CompareBranch);
template void Actions::push_back(action::SetInput);
template void Actions::push_back(action::SetMouse);
template void Actions::push_back(action::SetEditRule);
template void Actions::push_back(action::Rerun);
template void Actions::push_back(action::CancelRerun);
template void Actions::push_back(action::SetBreakpoint);
template void Actions::push_back(action::RemoveBreakpoint);
template void Actions::push_back(action::RunToStop);
template void Actions::push_back(action::FindParting);
template void Actions::push_back(action::SetParting);
template void Actions::push_back(action::CancelSearch);
template void Actions::push_back(action::SetWatch);
template void Actions::push_back(action::RemoveWatch);
template void Actions::push_back(action::CompareVariant);
template void Actions::push_back(action::SelectBody);
template void Actions::push_back(action::SelectSpawn);
template void Actions::push_back(action::SelectCurve);
template void Actions::push_back(action::SetCurveKind);
template void Actions::push_back(action::SelectTiles);
template void Actions::push_back(action::SetStamp);
template void Actions::push_back(action::SetRandomStamp);
template void Actions::push_back(action::SelectCells);
template void Actions::push_back(action::SetPasted);
template void Actions::push_back(action::SetMapTool);
template void Actions::push_back(action::SetSpriteTool);
template void Actions::push_back(action::SetBrush);
template void Actions::push_back(action::SelectPixels);
template void Actions::push_back(action::MovePixels);
template void Actions::push_back(action::TurnPixels);
template void Actions::push_back(action::PastePixels);
template void Actions::push_back(action::SetColor);
template void Actions::push_back(action::SetOverlay);
template void Actions::push_back(action::SetFlagOverlay);
template void Actions::push_back(action::SetOverlayPalette);
template void Actions::push_back(action::FindReach);
template void Actions::push_back(action::CancelReach);
template void Actions::push_back(action::ShowWay);
template void Actions::push_back(action::SetLintOptions);
template void Actions::push_back(action::SetGrid);
template void Actions::push_back(action::SetScreenBorders);

}  // namespace talus
