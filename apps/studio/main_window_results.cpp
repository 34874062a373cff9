// What `ease run` and `ease pattern` make of the scene, started from the window; the pattern beside the garment.
#include "apps/studio/main_window.h"

namespace ease {

std::filesystem::path MainWindow::resultsDirectory() const {
  const std::filesystem::path file = std::filesystem::absolute(studio_->document().file());
  return file.parent_path() / "results" / studio_->scene().name;
}

RunDialog* MainWindow::runCommands(const QStringList& commands) {
  const std::filesystem::path file = std::filesystem::absolute(studio_->document().file());
  auto* dialog = new RunDialog(commands, QString::fromStdString(file.string()),
                               QString::fromStdString(resultsDirectory().string()), this);
  dialog->show();
  return dialog;
}

RunDialog* MainWindow::run() {
  if (studio_->scene().garment.is_draft) {
    studio_->refuse("there is no garment to run yet: draw boundaries, then click a region");
    sync();
    return nullptr;
  }
  if (!save()) return nullptr;
  studio_->play(false);
  return runCommands({"run"});
}

RunDialog* MainWindow::makePattern() {
  namespace fs = std::filesystem;
  if (!studio_->made() || !studio_->made()->hasGarment() || studio_->isMaking()) {
    studio_->refuse(studio_->isMaking() ? "the garment is still being made: wait a moment, then try again"
                                        : "there is no garment yet: draw boundaries, then click a region");
    sync();
    return nullptr;
  }
  if (!(studio_->document().isSaved() && fs::exists(studio_->document().file())) && !save()) return nullptr;
  studio_->play(false);
  // The fit of an earlier state of the scene would give the pattern of another garment.
  std::error_code none;
  const fs::file_time_type fitted = fs::last_write_time(resultsDirectory() / "rest_shape.vtp", none);
  const bool is_fitted = !none && fitted >= fs::last_write_time(studio_->document().file(), none) && !none;
  RunDialog* dialog = runCommands(is_fitted ? QStringList{"pattern"} : QStringList{"run", "pattern"});
  connect(dialog, &RunDialog::succeeded, this, [this, made = studio_->made(), directory = resultsDirectory()] {
    try {
      showPattern(std::make_shared<const PatternSheet>(readPatternSheet(directory, made)));
      studio_->say("the pattern's files are in " + directory.string());
    } catch (const std::exception& error) {
      studio_->refuse(error.what());
    }
    sync();
  });
  return dialog;
}

void MainWindow::makePatternView() {
  pattern_ = new PatternView;
  pattern_->hide();
  connect(pattern_, &PatternView::picked, this, [this] { pickOnPaper(); });
}

void MainWindow::showPattern(std::shared_ptr<const PatternSheet> sheet) {
  if (sheet != pattern_->sheet()) pattern_->setSheet(std::move(sheet));
  other_->hide();
  pattern_->show();
  pickPart();
}

/// A seam of the scene is picked in the list too.
void MainWindow::pickOnPaper() {
  const SheetPick pick = pattern_->pick();
  std::optional<Part> found;
  for (const Part& part : partsOf(studio_->scene()))
    if (pick.what == SheetPick::What::line && part.label == pick.line &&
        part.kind == (pick.is_sewn ? PartKind::seam : PartKind::boundary))
      found = part;
  parts_->select(found);
  pattern_->setPick(pick);
  view_->setPicked(pattern_->sheet(), pick);
  if (pattern_->sheet()) studio_->say(pattern_->sheet()->wordsOf(pick));
  sync();
}

/// What is picked in the list is lit on the garment and on paper.
void MainWindow::pickPart() {
  const std::optional<Part> part = parts_->selected();
  view_->setSelected(part);
  SheetPick pick;
  if (part && (part->kind == PartKind::seam || part->kind == PartKind::boundary))
    pick = {SheetPick::What::line, 0, part->label, part->kind == PartKind::seam};
  pattern_->setPick(pick);
  view_->setPicked(pattern_->sheet(), pick);
}

}  // namespace ease
