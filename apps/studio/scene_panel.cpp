#include "apps/studio/scene_panel.h"

#include <QTextBlock>
#include <algorithm>

namespace ease {

ScenePanel::ScenePanel(QWidget* parent) : QPlainTextEdit(parent) {
  setReadOnly(true);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  QFont fixed("monospace");
  fixed.setStyleHint(QFont::TypeWriter);
  setFont(fixed);
}

void ScenePanel::show(const QString& text) {
  const QStringList now = text.split('\n'), before = before_.split('\n');
  const bool is_first = before_.isEmpty();
  before_ = text;
  const int shorter = std::min(now.size(), before.size());
  int first = 0, last = 0;
  while (first < shorter && now[first] == before[first]) ++first;
  while (last < shorter - first && now[now.size() - 1 - last] == before[before.size() - 1 - last]) ++last;
  setPlainText(text);
  QTextEdit::ExtraSelection changed;
  changed.cursor = QTextCursor(document()->findBlockByNumber(first));
  setTextCursor(changed.cursor);
  for (int line = first + 1; line < now.size() - last; ++line)
    changed.cursor.movePosition(QTextCursor::NextBlock, QTextCursor::KeepAnchor);
  changed.cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
  changed.format.setBackground(QColor(255, 240, 190));
  if (!is_first && first < now.size() - last) setExtraSelections({changed});
}

}  // namespace ease
