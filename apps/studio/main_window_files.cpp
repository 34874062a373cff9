// The scene's file in the window: opening, saving, and what is asked before work would be lost.
#include <QCloseEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QSettings>
#include <algorithm>

#include "apps/studio/main_window.h"

namespace ease {

void MainWindow::showAsBefore() {
  restoreGeometry(QSettings("ease", "studio").value("geometry").toByteArray());
  show();
}

bool MainWindow::save() {
  try {
    studio_->document().save();
    studio_->say("saved as " + studio_->document().file().string());
  } catch (const std::exception& error) {
    studio_->refuse(error.what());
  }
  showTitle();
  sync();
  return studio_->document().isSaved();
}

void MainWindow::saveAs() {
  const QString file = QFileDialog::getSaveFileName(
      this, "Save the scene as", QString::fromStdString(studio_->document().file().string()), "Scenes (*.toml)");
  if (file.isEmpty()) return;
  try {
    studio_->document().saveAs(file.toStdString());
    studio_->say("saved as " + file.toStdString());
  } catch (const std::exception& error) {
    studio_->refuse(error.what());
  }
  showTitle();
  sync();
}

void MainWindow::exportPicture() {
  const QString file = QFileDialog::getSaveFileName(this, "Save the picture as", "garment.png", "Pictures (*.png)");
  if (file.isEmpty()) return;
  if (view_->picture(2).save(file))
    studio_->say("picture saved as " + file.toStdString());
  else
    studio_->refuse(file.toStdString() + ": the picture cannot be written there");
  sync();
}

bool MainWindow::mayDropWork() {
  if (studio_->document().isSaved()) return true;
  const auto answer = QMessageBox::question(this, "Unsaved work", "Save the scene first?",
                                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool MainWindow::mayEndRun() {
  const QList<RunDialog*> dialogs = findChildren<RunDialog*>();
  if (std::none_of(dialogs.begin(), dialogs.end(), [](RunDialog* dialog) { return dialog->isRunning(); })) return true;
  return QMessageBox::question(this, "Still computing",
                               "A run or a pattern is still being computed. End it? What is written by then can be "
                               "opened, and a run can be gone on with.") == QMessageBox::Yes;
}

bool MainWindow::replaceBy(const std::function<Document()>& read, bool asks) {
  if (asks && !(mayDropWork() && mayEndRun())) return false;
  try {
    auto* window = new MainWindow(read());
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->restoreGeometry(saveGeometry());
    window->show();
    if (asks) window->offerUnsavedWork();
    studio_->document().discardUnsaved();
    setAttribute(Qt::WA_DeleteOnClose);
    asks_ = false;
    close();
    return true;
  } catch (const std::exception& error) {
    studio_->refuse(error.what());
    sync();
    return false;
  }
}

bool MainWindow::open(const QString& file, bool asks) {
  return replaceBy([&] { return Document::open(file.toStdString()); }, asks);
}

bool MainWindow::openNew() {
  const std::filesystem::path folder = studio_->document().file().parent_path();
  std::filesystem::path file = folder / "studio.toml";
  for (int k = 2; std::filesystem::exists(file) || std::filesystem::exists(Document::unsavedFile(file)); ++k)
    file = folder / ("studio " + std::to_string(k) + ".toml");
  return replaceBy([&] { return Document::builtin(file); }, true);
}

void MainWindow::offerUnsavedWork() {
  if (!studio_->document().wasRecovered()) return;
  const auto answer = QMessageBox::question(this, "Unsaved work",
                                            "Work on this scene that was not saved has been found. Keep it?\n"
                                            "(If not, Ctrl+Shift+Z still brings it back until the window is closed.)");
  if (answer == QMessageBox::No) studio_->undo();
  sync();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (asks_ && !(mayDropWork() && mayEndRun())) return event->ignore();
  if (asks_) {  // this window is not replaced by another
    studio_->document().discardUnsaved();
    QSettings("ease", "studio").setValue("geometry", saveGeometry());
  }
  event->accept();
}

}  // namespace ease
