// The list of all parts of the garment: select, rename, delete.
#pragma once

#include <QTreeWidget>
#include <optional>

#include "apps/studio/studio.h"

namespace ease {

class PartsTree : public QTreeWidget {
  Q_OBJECT

 public:
  explicit PartsTree(Studio& studio, QWidget* parent = nullptr);

  /// Lists the parts that there are now.
  void list();
  std::optional<Part> selected() const;
  /// Selects a part as a click does; none: nothing.
  void select(const std::optional<Part>& part);
  void removeSelected();
  void renameSelected();

 Q_SIGNALS:
  void selectionMade();
  void used();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void rename(QTreeWidgetItem* item);

  Studio& studio_;
  std::vector<Part> parts_;
};

}  // namespace ease
