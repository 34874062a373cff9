// What the window's scene file makes, and runs that are started from the window (main_window_results.cpp).
#include <QProcess>
#include <QtTest>

#include "apps/studio/keep_on_screen.h"
#include "solver/io/mesh_io.h"
#include "tests/studio/main_window_test.h"

namespace ease {

void WindowTest::theSavedFileMakesTheSameGarment() {
  key(Qt::Key_S, Qt::ControlModifier);
  QVERIFY(window_->studio().document().isSaved());
  QProcess process;
  process.start(EASE_COMMAND, {"garment", directory_.path() + "/dress.toml", "-o", directory_.path() + "/made"});
  QVERIFY(process.waitForFinished(60000));
  QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
  const TriangleMesh made = readMesh((directory_.path() + "/made/garment.obj").toStdString());
  const TriangleMesh& here = window_->studio().made()->input.garment;
  QVERIFY(made.triangles == here.triangles);
  QVERIFY((made.positions - here.positions).cwiseAbs().maxCoeff() < 1e-9);
}

/// A run is a process of its own; what is written when it is cancelled can be opened.
void WindowTest::aRunCanBeCancelled() {
  RunDialog* dialog = window_->run();
  QVERIFY2(dialog, window_->studio().words().c_str());
  QTRY_VERIFY_WITH_TIMEOUT(dialog->isRunning(), 10000);
  QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(directory_.path() + "/results/dress") || !dialog->isRunning(), 60000);
  QVERIFY(dialog->isRunning());
  QTest::qWait(300);
  dialog->interrupt();
  QTRY_VERIFY_WITH_TIMEOUT(!dialog->isRunning(), 60000);
  QVERIFY(QFile::exists(directory_.path() + "/results/dress/report.json"));
  QVERIFY2(dialog->text().startsWith("It was ended"), qPrintable(dialog->text()));
  keepOnScreen(*dialog);
  QVERIFY(dialog->screen()->availableGeometry().contains(dialog->frameGeometry()));
  dialog->close();
}

void WindowTest::theNextWindowIsAsLargeAsTheLast() {
  QVERIFY(window_->save());
  window_->showMaximized();
  QTRY_VERIFY(window_->isMaximized());
  QVERIFY(window_->close());
  MainWindow next(Document::builtin((directory_.path() + "/next.toml").toStdString()));
  next.showAsBefore();
  QTRY_VERIFY(next.isMaximized());
  keepOnScreen(next);
  QVERIFY(next.isMaximized());
}

}  // namespace ease
