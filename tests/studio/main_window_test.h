// A dress by mouse and keys, as in Figure 4 of Wolff et al. 2022, in the real window, without a display.  Points are
// given in metres and projected, so that neither layout nor fonts matter.  With EASE_STUDIO_PICTURES=FOLDER, pictures
// of the window are kept there.
#pragma once

#include "tests/studio/window_hands.h"

namespace ease {

class WindowTest : public WindowHands {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void theWindowShowsTheBody();
  void loopsAreDrawnByClicks();
  void aClickMakesCloth();
  void aDragMakesASkirt();
  void pinSeamAndComfort();
  void theClothMovesAndTurnsToAnotherPose();
  void sleevesArePuffedWhileItRuns();
  void undoAndRedoByKeys();
  void partsAreRenamedAndRemovedInTheList();
  void numberFieldsLeaveKeysAndWheelAlone();
  void nonsenseIsAnswered();
  void staticPicturesRepeat();
  void theSavedFileMakesTheSameGarment();
  void aRunCanBeCancelled();
  void nothingIsCutOffAtLargeText();
  void theResultWindowShowsTheWholePicture();
  void aSceneIsBegunOnScansAndGetsPoses();
  void theNextWindowIsAsLargeAsTheLast();
  void cleanupTestCase();
};
}  // namespace ease
