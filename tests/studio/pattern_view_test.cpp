#include "tests/studio/pattern_view_test.h"

#include <QApplication>
#include <QtTest>

#include "tests/studio/hands.h"

namespace ease {

void PatternViewTest::initTestCase() {
  QVERIFY(directory_.isValid());
  window_ = std::make_unique<MainWindow>(Document(kSmallDraft, (directory_.path() + "/top.toml").toStdString()));
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  wait();
}

void PatternViewTest::cleanupTestCase() {
  window_->studio().document().save();
  window_.reset();
}

void PatternViewTest::clickPaper(const PaperPoint& at) {
  const QPoint pixel = window_->pattern().pixelOf(at);
  QVERIFY(window_->pattern().rect().contains(pixel));
  const QPoint in_window = window_->pattern().mapTo(window_.get(), pixel);
  QTest::mouseMove(window_->windowHandle(), in_window);
  QTest::mouseClick(window_->windowHandle(), Qt::LeftButton, {}, in_window);
  QTest::qWait(30);
}

PaperPoint PatternViewTest::middleOf(const std::string& line) const {
  for (const SheetPiece& piece : window_->pattern().sheet()->pieces)
    for (const SheetEdge& edge : piece.edges)
      if (edge.name == line) return edge.points[edge.points.size() / 2];
  return PaperPoint::Zero();
}

bool PatternViewTest::isLitOnPaper(const std::string& line) const {
  const QPoint at = window_->pattern().pixelOf(middleOf(line));
  return pixelsNear(window_->pattern().grab(QRect(at - QPoint(2, 2), QSize(5, 5))).toImage(), kHoverColor, 40) > 4;
}

void PatternViewTest::withoutAGarmentThereIsNoPattern() {
  key(Qt::Key_P, Qt::ControlModifier);
  QVERIFY(window_->studio().isRefusal());
  QVERIFY(!window_->pattern().isVisible());
  key(Qt::Key_F9);
  QVERIFY(window_->pattern().isVisible());  // and says how to make one
  key(Qt::Key_F6);
  QVERIFY(window_->studio().gesture(sewnTop(), "a top with seams"));
  wait();
  QVERIFY2(window_->studio().stage.hasCloth(), window_->studio().words().c_str());
}

void PatternViewTest::thePatternCommandShowsThePieces() {
  key(Qt::Key_P, Qt::ControlModifier);
  auto* dialog = window_->findChild<RunDialog*>();
  QVERIFY2(dialog, window_->studio().words().c_str());
  QTRY_VERIFY_WITH_TIMEOUT(!dialog->isRunning(), 120000);
  dialog->close();
  QVERIFY2(window_->pattern().sheet(), window_->studio().words().c_str());
  QVERIFY(window_->pattern().isVisible());
  QCOMPARE(window_->pattern().sheet()->pieces.size(), size_t(2));
  QTest::qWait(50);
  const QImage paper = window_->pattern().grab().toImage();
  QVERIFY(pixelsNear(paper, kSeamColor, 12) > 100);
  QVERIFY(pixelsNear(paper, kLoopColor, 12) > 100);
  QCOMPARE(pixelsNear(paper, kHoverColor, 12), 0L);
}

void PatternViewTest::aPieceOnPaperLightsUpOnTheGarment() {
  turn(0);
  // The piece around a vertex of the chest.
  const Vec3 chest = onCloth({0.03, 1.2, 0.13});
  const QPoint at = window_->view().pixelOf(chest);
  const double ratio = window_->devicePixelRatioF();
  const int triangle = window_->studio().stage.hitCloth(ratio * at.x(), ratio * at.y())->place.triangle;
  const PatternSheet& sheet = *window_->pattern().sheet();
  size_t front = 0;
  for (size_t p = 0; p < sheet.pieces.size(); ++p)
    for (const int number : sheet.pieces[p].numbers)
      if (std::count(sheet.triangles[number].begin(), sheet.triangles[number].end(), triangle)) front = p;
  const auto isOrange = [&] {
    const QColor color = window_->view().picture().pixelColor(ratio * at);
    return color.red() > color.blue() + 60;
  };
  QVERIFY(!isOrange());
  clickPaper(sheet.pieces[front].name_at + PaperPoint(40, 40));
  QCOMPARE(window_->pattern().pick().piece, front);
  QVERIFY(isOrange());
  keepPicture("6_pattern");
  clickPaper(sheet.pieces[1 - front].name_at + PaperPoint(40, 40));
  QVERIFY(!isOrange());
}

void PatternViewTest::aSeamOnPaperLightsUpOnTheGarmentAndInTheList() {
  turn(90);
  const long before = pixelsNear(window_->view().picture(), kHoverColor, 12);
  clickPaper(middleOf("left side"));
  QCOMPARE(window_->pattern().pick().line, std::string("left side"));
  QVERIFY(pixelsNear(window_->view().picture(), kHoverColor, 12) > before + 50);
  const std::optional<Part> part = window_->findChild<PartsTree*>()->selected();
  QVERIFY(part.has_value());
  QCOMPARE(part->label, std::string("left side"));
  QVERIFY(isLitOnPaper("left side"));
  QVERIFY(!isLitOnPaper("right side"));
  QVERIFY(window_->statusText().contains(" cm to sew"));
}

void PatternViewTest::aSeamInTheListLightsUpOnPaper() {
  auto* tree = window_->findChild<PartsTree*>();
  QTreeWidgetItem* item = tree->topLevelItem(static_cast<int>(PartKind::seam))->child(1);
  tree->scrollToItem(item);
  QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(item).center());
  QTest::qWait(30);
  QCOMPARE(window_->pattern().pick().line, std::string("right side"));
  QVERIFY(isLitOnPaper("right side"));
  QVERIFY(!isLitOnPaper("left side"));
}

void PatternViewTest::aSeamOnTheGarmentLightsUpOnPaper() {
  turn(90);
  key(Qt::Key_7);
  const std::vector<int>& seam = window_->studio().made()->input.authored->seams.front().vertices;
  click(window_->studio().stage.cloth().row(seam[seam.size() / 2]).transpose());
  QTest::qWait(30);
  keepPicture("7_seam");
  QVERIFY2(window_->pattern().pick().line == "left side", window_->studio().words().c_str());
  QVERIFY(isLitOnPaper("left side"));
}

void PatternViewTest::theWheelZoomsAndADoubleClickShowsAll() {
  PatternView& paper = window_->pattern();
  const QPoint before = paper.pixelOf({0, 0}), middle = paper.rect().center();
  QWheelEvent wheel(middle, paper.mapToGlobal(middle), {}, {0, 240}, {}, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&paper, &wheel);
  QVERIFY(paper.pixelOf({0, 0}) != before);
  QTest::mouseDClick(window_->windowHandle(), Qt::LeftButton, {}, paper.mapTo(window_.get(), middle));
  QCOMPARE(paper.pixelOf({0, 0}), before);
}

}  // namespace ease

QTEST_MAIN(ease::PatternViewTest)
