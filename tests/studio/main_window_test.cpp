#include "tests/studio/main_window_test.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QtTest>

namespace ease {

void WindowTest::initTestCase() {
  QVERIFY(directory_.isValid());
  const std::string file = (directory_.path() + "/dress.toml").toStdString();
  Document document = Document::builtin(file);
  SceneText text(document.text());
  text.setValue("garment", 0, "resolution", "1500");
  text.setValue("body", 0, "seconds_per_pose", "0.25");
  window_ = std::make_unique<MainWindow>(Document(text.text(), file));
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  wait();
}

void WindowTest::cleanupTestCase() {
  window_->studio().document().save();
  window_.reset();
}

void WindowTest::theWindowShowsTheBody() {
  const QImage image = window_->view().picture();
  const QPoint chest = window_->view().pixelOf(onBody({0, 1.2, 0.12})) * window_->devicePixelRatioF();
  const QColor body = image.pixelColor(chest), air = image.pixelColor(3, 3);
  QVERIFY(body.value() < air.value() - 10);
  QVERIFY(std::abs(body.red() - body.blue()) < 40);
  QVERIFY(window_->findChild<QListWidget*>()->count() == 3);
  for (const Positions& pose : window_->studio().bodyInput().poses)  // raised arms are in sight
    for (const auto& x : pose.rowwise())
      QVERIFY(window_->view().rect().contains(window_->view().pixelOf(x.transpose())));
  keepPicture("1_body");
}

void WindowTest::loopsAreDrawnByClicks() {
  key(Qt::Key_1);
  loop({{-0.07, 1.47, 0.05}, {0.0, 1.45, 0.08}, {0.07, 1.47, 0.05}}, {{0.06, 1.5, -0.05}, {-0.06, 1.5, -0.05}});
  QCOMPARE(window_->studio().made()->loops.size(), size_t(1));
  const QImage image = window_->view().picture();
  QVERIFY(pixelsNear(image, kLoopColor, 30) > 20);
  // Sleeves: one by hand, the other mirrored.
  key(Qt::Key_M);
  loop({{0.42, 1.42, 0.03}, {0.42, 1.37, 0.04}}, {{0.42, 1.36, -0.03}, {0.42, 1.42, -0.03}});
  key(Qt::Key_M);
  QCOMPARE(window_->studio().made()->loops.size(), size_t(3));
  // The first three clicks of the waist, as they are shown, then the rest.
  turn(0);
  for (const Vec3& point : {Vec3(-0.13, 1.02, 0.05), Vec3(0, 1.02, 0.12)}) click(onBody(point));
  move(window_->view().pixelOf(onBody({0.1, 1.02, 0.08})));
  QTest::qWait(50);
  keepPicture("2_boundary");
  click(onBody({0.13, 1.02, 0.05}));
  turn(180);
  for (const Vec3& point : {Vec3(0.1, 1.02, -0.1), Vec3(-0.1, 1.02, -0.1)}) click(onBody(point));
  key(Qt::Key_Return);
  wait();
  QVERIFY2(!window_->studio().isRefusal(), window_->studio().words().c_str());
  QCOMPARE(window_->studio().made()->loops.size(), size_t(4));
  QVERIFY(garment().is_draft);
}

void WindowTest::aClickMakesCloth() {
  turn(0);
  key(Qt::Key_2);
  move(window_->view().pixelOf(onBody({0, 1.2, 0.12})));
  QTest::qWait(50);
  keepPicture("3_region");
  click(onBody({0, 1.2, 0.12}));
  wait();
  QVERIFY2(window_->studio().stage.hasCloth(), window_->studio().words().c_str());
  QVERIFY(!garment().is_draft);
  window_->view().setShown(Shown::cloth);
  const QColor cloth = window_->view().picture().pixelColor(window_->view().pixelOf(onCloth({0.03, 1.2, 0.13})));
  QVERIFY(cloth.blue() > cloth.red() + 15);  // the colour of cloth, not of skin
  window_->view().setShown(Shown::stretch);
}

void WindowTest::aDragMakesASkirt() {
  key(Qt::Key_3);
  const std::string waist = loopNear({0, 1.0, 0});
  const QPoint from = window_->view().pixelOf(onLoop(waist));
  drag(Qt::LeftButton, from, window_->view().pixelOf(onLoop(waist) - Vec3(0, 0.25, 0)) + QPoint(40, 0));
  wait();
  QVERIFY2(!window_->studio().isRefusal(), window_->studio().words().c_str());
  QCOMPARE(garment().tools->extensions.size(), size_t(1));
  QVERIFY(garment().tools->extensions.front().length > 0.15);
  QVERIFY(window_->studio().stage.cloth().col(1).minCoeff() < 0.85);
}

void WindowTest::pinSeamAndComfort() {
  key(Qt::Key_6);
  click(onLoop(loopNear({0, 1.5, 0})));
  wait();
  QCOMPARE(garment().pins.size(), size_t(1));
  key(Qt::Key_7);
  click(onLoop(loopNear({0, 1.5, 0})));
  click(onCloth({0.0, 1.2, 0.13}));
  click(onLoop(loopNear({0, 0.8, 0})));
  wait();
  QVERIFY2(!window_->studio().isRefusal(), window_->studio().words().c_str());
  QCOMPARE(garment().tools->seams.size(), size_t(1));
  key(Qt::Key_5);
  drag(Qt::LeftButton, window_->view().pixelOf(onCloth({-0.05, 1.1, 0.13})),
       window_->view().pixelOf(onCloth({0.08, 1.1, 0.13})));
  wait();
  QCOMPARE(garment().comfort_regions.size(), size_t(1));
  QVERIFY(garment().comfort_regions.front().stroke.size() > 2);
}

void WindowTest::theClothMovesAndTurnsToAnotherPose() {
  const Positions before = window_->studio().stage.cloth();
  key(Qt::Key_Space);
  QTRY_VERIFY_WITH_TIMEOUT(window_->studio().frame()->steps > 20, 20000);
  QVERIFY(window_->studio().stage.cloth() != before);
  auto* poses = window_->findChild<QListWidget*>();
  QTest::mouseClick(poses->viewport(), Qt::LeftButton, {}, poses->visualItemRect(poses->item(1)).center());
  QTRY_VERIFY_WITH_TIMEOUT(window_->studio().frame()->pose == 1 && window_->studio().frame()->way > 0.99, 30000);
  keepPicture("4_pose");
}

void WindowTest::sleevesArePuffedWhileItRuns() {
  QVERIFY(window_->studio().simulation().plays());
  key(Qt::Key_4);
  const SurfacePlace sleeve = nearestPlace({0.36, 1.42, 0.03}, window_->studio().stage.clothAsMade().positions,
                                           window_->studio().stage.clothAsMade().triangles);
  const Triangles& triangles = window_->studio().stage.clothAsMade().triangles;
  const Vec3 shown = placeOn(sleeve, window_->studio().stage.cloth(), triangles);
  const QPoint from = window_->view().pixelOf(shown);
  const double ratio = window_->devicePixelRatioF();
  const auto hit = window_->studio().stage.hitCloth(ratio * from.x(), ratio * from.y());
  QVERIFY(hit.has_value());
  drag(Qt::LeftButton, from, from + QPoint(6, 14));
  QTRY_VERIFY_WITH_TIMEOUT(!window_->studio().isMaking(), 20000);
  QVERIFY2(garment().paint.size() == 1, window_->studio().words().c_str());
  QTRY_VERIFY_WITH_TIMEOUT(
      *std::max_element(window_->studio().frame()->growth.begin(), window_->studio().frame()->growth.end()) > 1.05,
      20000);
  keepPicture("5_paint");
  key(Qt::Key_Space);
  wait();
  QVERIFY(!window_->studio().simulation().plays());
}

void WindowTest::undoAndRedoByKeys() {
  const std::string text = window_->studio().text();
  key(Qt::Key_Z, Qt::ControlModifier);
  wait();
  QVERIFY(garment().paint.empty());
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  wait();
  QCOMPARE(window_->studio().text(), text);
}

void WindowTest::partsAreRenamedAndRemovedInTheList() {
  auto* tree = window_->findChild<PartsTree*>();
  const std::string text = window_->studio().text();
  QTreeWidgetItem* first = tree->topLevelItem(0)->child(0);
  first->setText(0, "neckline");
  wait();
  QCOMPARE(garment().tools->boundaries.front().name, std::string("neckline"));
  QCOMPARE(std::get<std::string>(garment().pins.front().what), std::string("neckline"));
  QCOMPARE(garment().tools->seams.front().from, std::string("neckline"));
  QTreeWidgetItem* comfort = tree->topLevelItem(static_cast<int>(PartKind::comfort));
  tree->setCurrentItem(comfort->child(0));
  QTest::keyClick(tree, Qt::Key_Delete);
  wait();
  QVERIFY(garment().comfort_regions.empty());
  window_->studio().undo();
  wait();
  QCOMPARE(garment().comfort_regions.size(), size_t(1));
}

void WindowTest::nonsenseIsAnswered() {
  const std::string text = window_->studio().text();
  for (int tool = 0; tool < 7; ++tool) {
    key(static_cast<Qt::Key>(Qt::Key_1 + tool));
    move({2, 2});
    QTest::mouseClick(window_->windowHandle(), Qt::LeftButton, {}, inWindow({2, 2}));
    QVERIFY(window_->studio().isRefusal());
    QVERIFY(!window_->statusText().isEmpty());
    key(Qt::Key_Escape);
  }
  key(Qt::Key_1);
  key(Qt::Key_Return);
  QVERIFY(window_->studio().isRefusal());
  key(Qt::Key_Delete);
  QVERIFY(window_->studio().isRefusal());
  QCOMPARE(window_->studio().text(), text);
}

void WindowTest::numberFieldsLeaveKeysAndWheelAlone() {
  auto* limit = window_->findChild<QDoubleSpinBox*>("limit");
  QVERIFY(limit);
  const double before = limit->value();
  window_->view().setFocus();
  const QPointF at(5.0, 5.0);
  QWheelEvent wheel(at, limit->mapToGlobal(at.toPoint()), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(limit, &wheel);
  QCOMPARE(limit->value(), before);

  limit->setFocus();
  limit->selectAll();
  QTest::keyClicks(limit, "12");
  QTest::keyClick(limit, Qt::Key_Return);
  wait();
  QCOMPARE(window_->studio().scene().adaption->limit, 0.12);
  QTest::keyClick(limit, Qt::Key_Z, Qt::ControlModifier);
  wait();
  QCOMPARE(limit->value(), before);
  QTest::keyClick(limit, Qt::Key_Space);
  QVERIFY(window_->studio().simulation().plays());
  QTest::keyClick(limit, Qt::Key_Space);
  QVERIFY(!window_->studio().simulation().plays());
  wait();
  window_->view().setFocus();
}

/// Mean colours of 16 x 16 blocks of two pictures differ in at most half a per cent of the blocks.
void WindowTest::staticPicturesRepeat() {
  const auto draw = [this] {
    window_->studio().startOver();
    window_->studio().step(5);
    wait();
    return window_->view().picture();
  };
  const QImage first = draw(), second = draw();
  QCOMPARE(first.size(), second.size());
  int blocks = 0, different = 0;
  for (int y = 0; y + 16 <= first.height(); y += 16)
    for (int x = 0; x + 16 <= first.width(); x += 16) {
      double difference = 0.0;
      for (int k = 0; k < 256; ++k) {
        const QColor a = first.pixelColor(x + k % 16, y + k / 16), b = second.pixelColor(x + k % 16, y + k / 16);
        difference +=
            (std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue())) / 768.0;
      }
      ++blocks;
      different += difference > 12.0 ? 1 : 0;
    }
  QVERIFY(different <= 0.005 * blocks);
}

/// With text of one and a half times the size, the window still fits 1280 x 800 and its parts fit into it.
void WindowTest::nothingIsCutOffAtLargeText() {
  const QFont font = QApplication::font();
  QFont large = font;
  if (window_->logicalDpiX() < 120) large.setPointSizeF(1.5 * font.pointSizeF());
  QApplication::setFont(large);
  {
    MainWindow window(Document::builtin((directory_.path() + "/large.toml").toStdString()));
    window.resize(1280, 800);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QTest::qWait(100);
    QCOMPARE(window.size(), QSize(1280, 800));
    QVERIFY(window.view().width() >= 500);
    for (int tool = 0; tool < 7; ++tool) {
      window.chooseTool(static_cast<PartKind>(tool));
      QTest::qWait(20);
      for (const QWidget* part : window.findChildren<QWidget*>()) {
        const auto* button = qobject_cast<const QAbstractButton*>(part);
        const bool has_text = qobject_cast<const QLabel*>(part) || (button && !button->text().isEmpty()) ||
                              qobject_cast<const QAbstractSpinBox*>(part) || qobject_cast<const QTabBar*>(part) ||
                              qobject_cast<const QMenuBar*>(part);
        if (!has_text || !part->isVisible()) continue;
        const QSize least = part->minimumSizeHint();
        const QByteArray name = QByteArray(part->metaObject()->className()) + " " + part->objectName().toUtf8();
        QVERIFY2(part->width() >= least.width() && part->height() >= std::min(least.height(), part->maximumHeight()),
                 name.constData());
        QVERIFY2(part->objectName() != "qt_toolbar_ext_button", "a tool bar is too narrow for its buttons");
        const bool is_setting = QStringList{"radius", "scale", "offset", "mirror"}.contains(part->objectName());
        QVERIFY2(!is_setting || part->visibleRegion().boundingRect() == part->rect(), name.constData());
      }
      for (const QScrollArea* area : window.findChildren<QScrollArea*>())
        if (area->isVisible())
          QVERIFY2(!area->horizontalScrollBar()->isVisible(), qPrintable(area->parentWidget()->objectName()));
    }
    window.studio().document().save();
  }
  QApplication::setFont(font);
}

}  // namespace ease

QTEST_MAIN(ease::WindowTest)
