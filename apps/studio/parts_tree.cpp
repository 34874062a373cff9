#include "apps/studio/parts_tree.h"

#include <QKeyEvent>
#include <QSignalBlocker>
#include <QTreeWidgetItemIterator>

#include "solver/base/error.h"

namespace ease {

namespace {

constexpr int kNumber = Qt::UserRole;  // of the part in the list; -1: a kind

}  // namespace

PartsTree::PartsTree(Studio& studio, QWidget* parent) : QTreeWidget(parent), studio_(studio) {
  setHeaderHidden(true);
  setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  setToolTip("F2 renames a boundary or seam wherever it is named, Del removes a part");
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) { rename(item); });
  connect(this, &QTreeWidget::itemSelectionChanged, this, &PartsTree::selectionMade);
}

void PartsTree::list() {
  const std::optional<Part> before = selected();
  const QSignalBlocker block(this);
  clear();
  parts_ = partsOf(studio_.scene());
  for (int kind = 0; kind <= static_cast<int>(PartKind::seam); ++kind) {
    auto* group = new QTreeWidgetItem(this, {pluralOf(static_cast<PartKind>(kind))});
    group->setData(0, kNumber, -1);
    for (size_t k = 0; k < parts_.size(); ++k) {
      const Part& part = parts_[k];
      if (part.kind != static_cast<PartKind>(kind)) continue;
      auto* item = new QTreeWidgetItem(group, {QString::fromStdString(part.label)});
      item->setData(0, kNumber, static_cast<int>(k));
      if (part.kind == PartKind::boundary || part.kind == PartKind::seam)
        item->setFlags(item->flags() | Qt::ItemIsEditable);
      if (before && part == *before) item->setSelected(true);
    }
    group->setHidden(group->childCount() == 0);
  }
  expandAll();
}

std::optional<Part> PartsTree::selected() const {
  const QList<QTreeWidgetItem*> items = selectedItems();
  if (items.isEmpty()) return std::nullopt;
  const int number = items.front()->data(0, kNumber).toInt();
  if (number < 0 || number >= static_cast<int>(parts_.size())) return std::nullopt;
  return parts_[number];
}

void PartsTree::select(const std::optional<Part>& part) {
  clearSelection();
  for (QTreeWidgetItemIterator item(this); part && *item; ++item)
    if (const int number = (*item)->data(0, kNumber).toInt(); number >= 0 && parts_[number] == *part)
      return setCurrentItem(*item);
}

void PartsTree::removeSelected() {
  const std::optional<Part> part = selected();
  if (!part)
    studio_.refuse("select a part in the list first; Del then removes it");
  else if (const std::string user = userOf(studio_.scene(), *part); !user.empty())
    studio_.refuse("'" + part->label + "' is used by the " + user + ": remove that first");
  else
    studio_.gesture(without(studio_.text(), *part), "remove '" + part->label + "'");
  Q_EMIT used();
}

void PartsTree::renameSelected() {
  const QList<QTreeWidgetItem*> items = selectedItems();
  if (!items.isEmpty() && (items.front()->flags() & Qt::ItemIsEditable)) return editItem(items.front());
  studio_.refuse("select a boundary or a seam in the list first");
  Q_EMIT used();
}

void PartsTree::rename(QTreeWidgetItem* item) {
  const int number = item->data(0, kNumber).toInt();
  if (number < 0 || number >= static_cast<int>(parts_.size())) return;
  const Part part = parts_[number];
  const std::string name = item->text(0).toStdString();
  if (name == part.label) return;
  try {
    studio_.gesture(renamed(studio_.text(), studio_.scene(), part, name), "rename '" + part.label + "'");
  } catch (const InputError& error) {
    studio_.refuse(error.what());
  }
  const QSignalBlocker block(this);
  item->setText(0, QString::fromStdString(part.label));  // list() brings the new one
  Q_EMIT used();
}

void PartsTree::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete) return removeSelected();
  QTreeWidget::keyPressEvent(event);
}

}  // namespace ease
