// What the window's scene file makes, and runs that are started from the window (main_window_results.cpp).
#include <QApplication>
#include <QDir>
#include <QImage>
#include <QLabel>
#include <QPointer>
#include <QProcess>
#include <QtTest>
#include <algorithm>

#include "apps/studio/keep_on_screen.h"
#include "apps/studio/parts.h"
#include "solver/base/whole_file.h"
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

void WindowTest::theResultWindowShowsTheWholePicture() {
  const QString results = directory_.path() + "/shown";
  QVERIFY(QDir().mkpath(results));
  QImage picture(1600, 1000, QImage::Format_RGB32);
  picture.fill(Qt::red);
  QVERIFY(picture.save(results + "/pattern_resewn.png"));  // which a command other than run shows
  auto* dialog = new RunDialog({"garment"}, directory_.path() + "/dress.toml", results, window_.get());
  dialog->show();
  QTRY_VERIFY_WITH_TIMEOUT(!dialog->isRunning() && dialog->text().startsWith("Results in"), 60000);
  const QList<QLabel*> labels = dialog->findChildren<QLabel*>();
  const auto shown = std::find_if(labels.begin(), labels.end(),
                                  [](QLabel* label) { return !label->pixmap(Qt::ReturnByValue).isNull(); });
  QVERIFY(shown != labels.end());
  QCoreApplication::processEvents();
  const QPixmap pixmap = (*shown)->pixmap(Qt::ReturnByValue);
  QVERIFY2((*shown)->width() >= pixmap.width() && (*shown)->height() >= pixmap.height(),
           qPrintable(QString("%1 of %2 pixels").arg((*shown)->width()).arg(pixmap.width())));
  dialog->close();
}

void WindowTest::aSceneIsBegunOnScansAndGetsPoses() {
  const SceneInput body = readBodyInput(Document::builtin("mannequin.toml").scene());
  QStringList scans;
  for (size_t p = 0; p < body.poses.size(); ++p) {
    scans.append(directory_.path() + QString("/pose%1.obj").arg(p));
    writeObj(scans.back().toStdString(), {body.poses[p], body.body_triangles});
  }
  QPointer<MainWindow> first = new MainWindow(Document::builtin((directory_.path() + "/scans.toml").toStdString()));
  first->studio().finishWork();
  QVERIFY(!first->addPoses(scans));
  QVERIFY(QString::fromStdString(first->studio().words()).contains("built-in"));
  QVERIFY(!first->openOnScans({directory_.path() + "/none.ply"}, false));
  QVERIFY(QString::fromStdString(first->studio().words()).contains("none.ply"));

  QPointer<MainWindow> second, third;
  const auto newest = [&] {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      auto* window = qobject_cast<MainWindow*>(widget);
      if (window && window != first && window != window_.get() && window != second.data()) return window;
    }
    return static_cast<MainWindow*>(nullptr);
  };
  QVERIFY(first->openOnScans({scans[1], scans[0]}, false));
  QTRY_VERIFY(first.isNull());
  second = newest();
  QVERIFY(second);
  second->studio().finishWork();
  QCOMPARE(second->studio().bodyInput().poses.size(), size_t{2});
  QVERIFY(second->studio().scene().body->poses.front() == "pose0.obj");

  Studio& studio = second->studio();
  const std::filesystem::path file = studio.document().file();
  const std::vector<Vec3> waist = {{0.15, 1.05, 0}, {0, 1.05, 0.12}, {-0.15, 1.05, 0}, {0, 1.05, -0.12}};
  QVERIFY2(studio.gesture(withBoundary(studio.text(), "waist", waist), "boundary"), studio.words().c_str());
  QVERIFY(!second->addPoses({scans[2]}));  // the boundary is still being made
  studio.finishWork();
  QVERIFY2(studio.text().find("waist") != std::string::npos, studio.words().c_str());
  const QString other = directory_.path() + "/triangle.obj";
  writeObj(other.toStdString(), {Positions::Identity(3, 3), Triangles{{0, 1, 2}}});
  const std::string unsaved = contentOf(Document::unsavedFile(file));
  QVERIFY(!second->addPoses({other}));
  QVERIFY2(studio.isRefusal() && studio.words().find("triangle.obj") != std::string::npos, studio.words().c_str());
  QVERIFY(contentOf(Document::unsavedFile(file)) == unsaved);
  QVERIFY(second->addPoses({scans[2]}));
  third = newest();
  QVERIFY(third);
  third->studio().finishWork();
  QCOMPARE(third->studio().bodyInput().poses.size(), size_t{3});
  QVERIFY(third->studio().document().file() == file);
  QTRY_VERIFY(second.isNull());
  QVERIFY(third->studio().text().find("waist") != std::string::npos);
  QVERIFY(contentOf(Document::unsavedFile(file)) == third->studio().text());
  QVERIFY(third->save());
  third->close();
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
