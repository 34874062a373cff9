#include "apps/studio/number_box.h"

#include <QKeyEvent>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QWheelEvent>

namespace ease {

namespace {

/// Whether a key writes or edits a number.
bool editsNumber(const QKeyEvent& key) {
  if (key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo)) return false;
  for (const auto standard : {QKeySequence::Copy, QKeySequence::Cut, QKeySequence::Paste, QKeySequence::SelectAll})
    if (key.matches(standard)) return true;
  if (key.key() >= 0x01000000) return true;  // arrows, Backspace, Enter and other keys that are no character
  const QString text = key.text();
  return !text.isEmpty() && (text[0].isDigit() || QString(".,-+").contains(text[0]));
}

}  // namespace

NumberBox::NumberBox() {
  setFocusPolicy(Qt::StrongFocus);  // not by the wheel
}

bool NumberBox::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !editsNumber(*static_cast<QKeyEvent*>(event))) {
    event->ignore();  // the window's shortcut acts
    return true;
  }
  return QDoubleSpinBox::event(event);
}

void NumberBox::wheelEvent(QWheelEvent* event) {
  if (!hasFocus()) return event->ignore();
  QDoubleSpinBox::wheelEvent(event);
}

void NumberBox::mouseReleaseEvent(QMouseEvent* event) {
  QDoubleSpinBox::mouseReleaseEvent(event);
  QStyleOptionSpinBox option;
  initStyleOption(&option);
  const QStyle::SubControl at = style()->hitTestComplexControl(QStyle::CC_SpinBox, &option, event->pos(), this);
  if (at == QStyle::SC_SpinBoxUp || at == QStyle::SC_SpinBoxDown) clearFocus();
}

}  // namespace ease
