// The sewing pattern beside the garment, by mouse and keys in the real window.  EASE_STUDIO_PICTURES=FOLDER keeps
// pictures.
#pragma once

#include "tests/studio/window_hands.h"

namespace ease {

class PatternViewTest : public WindowHands {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void withoutAGarmentThereIsNoPattern();
  void thePatternCommandShowsThePieces();
  void aPieceOnPaperLightsUpOnTheGarment();
  void aSeamOnPaperLightsUpOnTheGarmentAndInTheList();
  void aSeamInTheListLightsUpOnPaper();
  void aSeamOnTheGarmentLightsUpOnPaper();
  void theWheelZoomsAndADoubleClickShowsAll();
  void cleanupTestCase();

 private:
  void clickPaper(const PaperPoint& at);
  PaperPoint middleOf(const std::string& line) const;
  bool isLitOnPaper(const std::string& line) const;
};
}  // namespace ease
