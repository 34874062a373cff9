// Docks, menus, keys and tool bars of the window.
#include <QComboBox>
#include <QMenuBar>
#include <QMessageBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QToolBar>
#include <QVBoxLayout>

#include "apps/studio/main_window.h"

namespace ease {

QDockWidget* MainWindow::addDock(const QString& title, QWidget* content) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(title);
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  if (qobject_cast<QAbstractScrollArea*>(content)) {
    dock->setWidget(content);
  } else {
    auto* scroll = new QScrollArea;  // so that the window may be lower than what all docks want
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    dock->setWidget(scroll);
  }
  addDockWidget(Qt::RightDockWidgetArea, dock);
  return dock;
}

void MainWindow::makeDocks() {
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  tool_panel_ = new ToolPanel(*studio_);
  connect(tool_panel_, &ToolPanel::changed, this, [this] {
    studio_->say(tool_->hint());
    view_->refresh();
    sync();
  });
  parts_ = new PartsTree(*studio_);
  connect(parts_, &PartsTree::used, this, [this] { sync(); });
  connect(parts_, &PartsTree::selectionMade, this, [this] { pickPart(); });
  poses_ = new QListWidget;
  poses_->setViewMode(QListView::IconMode);
  poses_->setIconSize({60, 70});
  poses_->setMovement(QListView::Static);
  poses_->setResizeMode(QListView::Adjust);
  poses_->setToolTip("Click a pose: the body goes there from where it is");
  connect(poses_, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
    studio_->goTo(poses_->row(item));
    view_->refresh();
    sync();
  });
  report_ = new QLabel;
  report_->setMargin(4);
  under_ = new QLabel;
  under_->setMargin(4);
  under_->setWordWrap(true);
  under_->setToolTip("What was measured under the pointer");
  auto* measured = new QWidget;
  auto* rows = new QVBoxLayout(measured);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(report_);
  rows->addWidget(under_);
  rows->addStretch();
  cloth_panel_ = new ClothPanel(*studio_);
  connect(cloth_panel_, &ClothPanel::used, this, [this] { sync(); });
  scene_text_ = new ScenePanel;
  tool_dock_ = addDock("Tool", tool_panel_);
  QDockWidget* parts = addDock("Garment", parts_);
  QDockWidget* poses = addDock("Poses", poses_);
  QDockWidget* report = addDock("Report", measured);
  QDockWidget* cloth = addDock("Cloth", cloth_panel_);
  QDockWidget* scene = addDock("Scene", scene_text_);
  tabifyDockWidget(report, cloth);
  tabifyDockWidget(cloth, scene);
  report->raise();
  const int line = fontMetrics().height();
  constexpr int kLargeText = 20;  // pixels a line: with more, five docks are too many for 800 pixels
  if (line > kLargeText) {
    tabifyDockWidget(parts, poses);
    parts->raise();
    resizeDocks({tool_dock_, parts, report}, {7 * line, 7 * line, 10 * line}, Qt::Vertical);
  } else {
    resizeDocks({tool_dock_, parts, poses, report}, {7 * line, 8 * line, 6 * line, 13 * line}, Qt::Vertical);
  }
  resizeDocks({tool_dock_}, {15 * line}, Qt::Horizontal);
}

QAction* MainWindow::add(QMenu* menu, const QString& text, const QString& keys, const QString& tip,
                         const std::function<void()>& act) {
  QAction* action = menu->addAction(text);
  QList<QKeySequence> sequences;
  for (const QString& key : keys.split(' ', Qt::SkipEmptyParts)) sequences.append(QKeySequence(key));
  action->setShortcuts(sequences);
  action->setToolTip(keys.isEmpty() ? tip : tip + " (" + keys + ")");
  action->setStatusTip("");
  connect(action, &QAction::triggered, this, [this, act] {
    act();
    view_->refresh();
    sync();
  });
  return action;
}

void MainWindow::makeActions() {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeToolBar();
  makeSimulationMenu();
  makeSettingsMenu();
}

void MainWindow::makeEditMenu() {
  QMenu* menu = menuBar()->addMenu("&Edit");
  undo_ = add(menu, "&Undo", "Ctrl+Z", "Takes the last gesture back, or the last point of a line that is being drawn",
              [this] { tool_->isDrawing() ? tool_->back() : studio_->undo(); });
  redo_ = add(menu, "&Redo", "Ctrl+Shift+Z Ctrl+Y", "Does the undone gesture again", [this] { studio_->redo(); });
  menu->addSeparator();
  add(menu, "&Close the line", "", "Closes the boundary or seam that is being drawn (Enter)",
      [this] { tool_->finish(); });
  add(menu, "&Drop the gesture", "", "Forgets what is being drawn (Esc)", [this] { tool_->cancel(); });
  menu->addSeparator();
  add(menu, "Re&name part", "F2", "Renames the selected boundary or seam wherever it is named",
      [this] { parts_->renameSelected(); });
  add(menu, "Re&move part", "", "Removes the part selected in the list (Del)", [this] { parts_->removeSelected(); });
}

void MainWindow::makeViewMenu() {
  QMenu* menu = menuBar()->addMenu("&View");
  add(menu, "&Front", "Ctrl+1", "From the front", [this] { look(0, 5); });
  add(menu, "&Back", "Ctrl+2", "From behind", [this] { look(180, 5); });
  add(menu, "&Left", "Ctrl+3", "From the wearer's left", [this] { look(90, 5); });
  add(menu, "&Right", "Ctrl+4", "From the wearer's right", [this] { look(-90, 5); });
  add(menu, "Fra&me", "F", "Fits the whole body into the view, or the garment where a part is selected",
      [this] { frameView(); });
  menu->addSeparator();
  QMenu* colors = menu->addMenu("&Colour");
  shown_ = new QActionGroup(this);
  const std::pair<const char*, Shown> kinds[] = {{"&Plain", Shown::cloth},       {"&Stretch", Shown::stretch},
                                                 {"P&ressure", Shown::pressure}, {"&Ease", Shown::ease},
                                                 {"&Growth", Shown::growth},     {"P&ieces", Shown::pieces}};
  for (const auto& [name, shown] : kinds) {
    QAction* action = add(colors, name, "", "What the cloth's colours show", [this, shown = shown] {
      view_->setShown(shown);
      other_->setShown(shown);
      studio_->simulation().wantFrame(shown == Shown::pressure || shown == Shown::ease);
    });
    action->setCheckable(true);
    action->setChecked(shown == Shown::stretch);
    shown_->addAction(action);
  }
  menu->addSeparator();
  QAction* body = menu->addAction("B&ody");
  body->setShortcut(QKeySequence("B"));
  body->setCheckable(true);
  body->setChecked(true);
  connect(body, &QAction::toggled, this, [this](bool on) { view_->showBody(on); });
  QAction* edges = menu->addAction("&Triangles");
  edges->setShortcut(QKeySequence("T"));
  edges->setCheckable(true);
  connect(edges, &QAction::toggled, this, [this](bool on) {
    view_->showEdges(on);
    other_->showEdges(on);
  });
  menu->addSeparator();
  add(menu, "One &view", "F6", "The simulated garment alone", [this] { compare(ViewWidget::Content::simulated); });
  add(menu, "Rest shape &beside", "F7", "The rest shape in a second view with the same camera",
      [this] { compare(ViewWidget::Content::rest); });
  add(menu, "&Pattern beside", "F9", "The pieces of the sewing pattern; what is picked there lights up on the garment",
      [this] { showPattern(pattern_->sheet()); });
  add(menu, "&Keep, and show beside", "F8", "Keeps the garment as it is now in a second view, to compare with later",
      [this] {
        if (!studio_->frame()) return studio_->refuse("there is no garment to keep yet");
        other_->keep(*studio_->frame());
        compare(ViewWidget::Content::kept);
      });
}

void MainWindow::makeToolBar() {
  auto* bar = new QToolBar("Tools");
  bar->setObjectName("tools");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  addToolBar(Qt::LeftToolBarArea, bar);
  QMenu* menu = menuBar()->addMenu("&Tools");
  tools_ = new QActionGroup(this);
  for (int k = 0; k <= static_cast<int>(PartKind::seam); ++k) {
    const auto kind = static_cast<PartKind>(k);
    QAction* action = add(menu, QString("%1 %2").arg(k + 1).arg(textOf(kind).name), QString::number(k + 1),
                          textOf(kind).does, [this, kind] { chooseTool(kind); });
    action->setCheckable(true);
    tools_->addAction(action);
    bar->addAction(action);
  }
  menu->addSeparator();
  add(menu, "Smaller brush", "[", "Makes the brush smaller", [this] { changeRadius(1 / 1.15); });
  add(menu, "Larger brush", "]", "Makes the brush larger", [this] { changeRadius(1.15); });
  add(menu, "Mirror", "M", "Draws the same on the other side", [this] {
    studio_->settings.mirror = !studio_->settings.mirror;
    tool_panel_->showSettings();
  });
}

void MainWindow::makeSimulationMenu() {
  QMenu* menu = menuBar()->addMenu("&Simulation");
  play_ = add(menu, "&Play", "Space", "Lets the cloth move, or pauses",
              [this] { studio_->play(!studio_->simulation().plays()); });
  play_->setCheckable(true);
  QAction* step = add(menu, "&Step", ".", "One time step", [this] { studio_->step(); });
  QAction* over = add(menu, "Start &over", "Ctrl+Home", "The garment as it was made, on the first pose",
                      [this] { studio_->startOver(); });
  adapt_ = add(menu, "&Let out", "A", "Lets the rest shape out where the cloth is stretched beyond the limit",
               [this] { studio_->setAdapting(!studio_->adapts()); });
  adapt_->setCheckable(true);
  tour_ = add(menu, "&Through all poses", "P", "The body goes from pose to pose, and back, until it is told to stay",
              [this] { studio_->tour(!studio_->isOnTour()); });
  tour_->setCheckable(true);
  auto* bar = new QToolBar("Simulation");
  bar->setObjectName("simulation");
  bar->setMovable(false);
  addToolBar(Qt::TopToolBarArea, bar);
  bar->addActions({play_, step, over, adapt_});
  bar->addSeparator();
  bar->addActions({undo_, redo_});
  bar->addSeparator();
  bar->addWidget(new QLabel("Colour: "));
  auto* colors = new QComboBox;
  colors->setToolTip("What the cloth's colours show");
  colors->setFocusPolicy(Qt::NoFocus);  // keys belong to the view
  for (QAction* action : shown_->actions()) colors->addItem(action->text().remove('&'));
  colors->setCurrentIndex(shown_->actions().indexOf(shown_->checkedAction()));
  connect(colors, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { shown_->actions()[index]->trigger(); });
  connect(shown_, &QActionGroup::triggered, colors,
          [this, colors](QAction* action) { colors->setCurrentIndex(shown_->actions().indexOf(action)); });
  bar->addWidget(colors);
}

void MainWindow::makeSettingsMenu() {
  QMenu* menu = menuBar()->addMenu("Settin&gs");
  auto* group = new QActionGroup(this);
  const std::pair<const char*, Navigation> kinds[] = {
      {"Mouse as in CLO: right button turns, middle moves", Navigation::clo},
      {"Mouse as in Blender: middle button turns, Shift moves", Navigation::blender},
      {"Mouse as in ParaView: left button turns beside body and cloth", Navigation::paraview}};
  const int chosen = QSettings("ease", "studio").value("navigation", 0).toInt();
  for (const auto& [name, navigation] : kinds) {
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, navigation = navigation] {
      QSettings("ease", "studio").setValue("navigation", static_cast<int>(navigation));
      view_->setNavigation(navigation);
      other_->setNavigation(navigation);
    });
    if (static_cast<int>(navigation) == chosen) {
      action->setChecked(true);
      view_->setNavigation(navigation);
      other_->setNavigation(navigation);
    }
  }
  QMenu* help = menuBar()->addMenu("&Help");
  add(help, "&Mouse and keys", "F1", "What the mouse and the keys do", [this] {
    QMessageBox::information(
        this, "Mouse and keys",
        "Left button: the tool.  Right drag: turn.  Middle drag: move.  Wheel: zoom.\n"
        "Alt+left: turn, Alt+Shift+left: move.\n"
        "Ctrl+wheel or [ ]: size of the brush.  Shift+wheel: strength.  Shift+drag: the opposite.\n"
        "1 to 7: tools.  Space: play or pause.  . : one step.  A: let out.  M: mirror.\n"
        "Enter closes a line, Backspace takes a point back, Esc drops it, Del removes.\n"
        "Ctrl+Z, Ctrl+Shift+Z: undo, redo.  Ctrl+1 to 4: front, back, left, right.  F: frame.");
  });
}

}  // namespace ease
