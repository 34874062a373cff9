// The scene's file in the window: opening, saving, and what is asked before work would be lost.
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <algorithm>

#include "apps/mesh_list.h"
#include "apps/studio/main_window.h"
#include "solver/base/error.h"

namespace ease {

namespace {

/// The files in the order of their names, as people number them.
std::vector<std::filesystem::path> ordered(const QStringList& files) {
  std::vector<std::string> names;
  for (const QString& file : files) names.push_back(file.toStdString());
  std::sort(names.begin(), names.end(), comesBeforeAsNumbered);
  return {names.begin(), names.end()};
}

}  // namespace

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu("&File");
  add(menu, "&New", "Ctrl+N", "Begins a new scene on the built-in body", [this] { openNew(); });
  add(menu, "New on s&cans ...", "Ctrl+Shift+N", "Begins a new scene on scans of one person in several poses",
      [this] { openOnScans(askForScans("Scans of one person, poses in the order of their names")); });
  add(menu, "A&dd poses ...", "", "Adds scans of the same person as poses; what was done so far cannot be undone then",
      [this] {
        if (mayAddPoses()) addPoses(askForScans("Further poses, in the order of their names"));
      });
  menu->addSeparator();
  add(menu, "&Open ...", "Ctrl+O", "Opens another scene", [this] {
    const QString file = QFileDialog::getOpenFileName(this, "Open a scene", "", "Scenes (*.toml)");
    if (!file.isEmpty()) open(file);
  });
  add(menu, "&Save", "Ctrl+S", "Writes the scene file that `ease run` takes", [this] { save(); });
  add(menu, "Save &as ...", "Ctrl+Shift+S", "Writes another scene file", [this] { saveAs(); });
  menu->addSeparator();
  add(menu, "Save &picture ...", "Ctrl+E", "Writes what the view shows, twice as large", [this] { exportPicture(); });
  menu->addSeparator();
  add(menu, "&Run ...", "Ctrl+R", "Saves, and does what `ease run` does", [this] { run(); });
  add(menu, "Pa&ttern ...", "Ctrl+P", "Saves, does what `ease pattern` does, and shows the pieces",
      [this] { makePattern(); });
  menu->addSeparator();
  add(menu, "&Quit", "Ctrl+Q", "Closes the window", [this] { close(); });
}

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

/// Asks for a file to write, whose name ends in `suffix` where no other is given; empty: none was chosen.
QString MainWindow::askForFile(const QString& title, const QString& file, const QString& filter,
                               const QString& suffix) {
  QFileDialog dialog(this, title, QFileInfo(file).path(), filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(QFileInfo(file).fileName());
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().front() : QString();
}

void MainWindow::saveAs() {
  const QString file = askForFile("Save the scene as", QString::fromStdString(studio_->document().file().string()),
                                  "Scenes (*.toml)", "toml");
  if (file.isEmpty()) return;
  try {
    studio_->document().saveAs(file.toStdString());
    text_revision_ = -1;  // names of meshes may have changed
    studio_->say("saved as " + file.toStdString());
  } catch (const std::exception& error) {
    studio_->refuse(error.what());
  }
  showTitle();
  sync();
}

void MainWindow::exportPicture() {
  const QString file = askForFile("Save the picture as", "garment.png", "Pictures (*.png)", "png");
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

bool MainWindow::replaceBy(const std::function<Document()>& read, bool asks, const std::string& words) {
  if (asks && !(mayDropWork() && mayEndRun())) return false;
  if (asks) studio_->document().discardUnsaved();  // or the other document might find it
  timer_.stop();
  try {
    auto* window = new MainWindow(read());
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->restoreGeometry(saveGeometry());
    window->show();
    window->studio().document().keepUnsaved();
    if (!words.empty()) window->studio().say(words);
    window->sync();
    if (asks) window->offerUnsavedWork();
    setAttribute(Qt::WA_DeleteOnClose);
    asks_ = false;
    close();
    return true;
  } catch (const std::exception& error) {
    timer_.start();
    studio_->document().keepUnsaved();
    studio_->refuse(error.what());
    sync();
    return false;
  }
}

bool MainWindow::open(const QString& file, bool asks) {
  return replaceBy([&] { return Document::open(file.toStdString()); }, asks);
}

std::filesystem::path MainWindow::folder() const {
  return studio_->document().file().parent_path();
}

bool MainWindow::openNew() {
  return replaceBy([&] { return Document::builtin(Document::freeFile(folder())); }, true);
}

bool MainWindow::openOnScans(const QStringList& scans, bool asks) {
  return !scans.empty() && replaceBy([&] { return Document::newOnScans(ordered(scans), folder()); }, asks);
}

bool MainWindow::mayAddPoses() {
  if (studio_->refuseWhileMaking()) return false;
  try {
    studio_->document().checkTakesPoses();
    return true;
  } catch (const InputError& error) {
    studio_->refuse(error.what());
    return false;
  }
}

bool MainWindow::addPoses(const QStringList& scans) {
  if (scans.empty() || !mayAddPoses() || !mayEndRun()) return false;
  return replaceBy([&] { return studio_->document().withPoses(ordered(scans)); }, false,
                   "poses added; what was done before cannot be undone any more");
}

QStringList MainWindow::askForScans(const QString& title) {
  return QFileDialog::getOpenFileNames(this, title, "", "Meshes (*.ply *.obj *.stl *.off *.vtp)");
}

void MainWindow::offerUnsavedWork() {
  if (!studio_->document().wasRecovered()) return;
  Document& document = studio_->document();
  QString question = "Work on this scene that was not saved has been found. Keep it?\n";
  question += document.canUndo() ? "(If not, Ctrl+Shift+Z still brings it back until the window is closed.)"
                                 : "(If not, it is deleted.)";
  QMessageBox box(QMessageBox::Question, "Unsaved work", question, QMessageBox::Yes | QMessageBox::No, this);
  box.setDefaultButton(QMessageBox::Yes);
  box.setEscapeButton(QMessageBox::Yes);
  if (box.exec() == QMessageBox::No) {
    if (document.canUndo()) {
      studio_->undo();
    } else {  // it is on another body
      document.discardUnsaved();
      replaceBy([&] { return document.withoutUnsaved(); }, false);
    }
  }
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
