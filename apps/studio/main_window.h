// The window of the editor: the view in the middle, tools on the left, lists and settings on the right.
#pragma once

#include <QActionGroup>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QProgressBar>
#include <QTimer>
#include <memory>

#include "apps/studio/cloth_panel.h"
#include "apps/studio/parts_tree.h"
#include "apps/studio/pattern_view.h"
#include "apps/studio/run_dialog.h"
#include "apps/studio/scene_panel.h"
#include "apps/studio/tool_panel.h"
#include "apps/studio/view_widget.h"

namespace ease {

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Document document);
  ~MainWindow() override;

  Studio& studio() { return *studio_; }
  ViewWidget& view() { return *view_; }
  Tool& tool() { return *tool_; }
  /// Shows the window where, and as large as, the last one was when it was closed.
  void showAsBefore();
  void chooseTool(PartKind kind);
  /// Takes what the other threads have finished, and shows what is new.
  void sync();
  /// Saves without asking; returns whether that succeeded.
  bool save();
  /// Opens another scene; asks about unsaved work if `asks`.
  bool open(const QString& file, bool asks = true);
  /// Begins a new scene on the built-in body, in a file whose name is free.
  bool openNew();
  /// Begins a new scene on scans of one person, the poses in the order of their names.
  bool openOnScans(const QStringList& scans, bool asks = true);
  /// Adds scans as poses after the last one; what is not saved is kept.
  bool addPoses(const QStringList& scans);
  /// Asks whether unsaved work that a crash left is kept, if there is any.
  void offerUnsavedWork();
  /// Does what `ease run` does with the saved scene.
  RunDialog* run();
  /// Does what `ease pattern` does with it, runs it first where that has not been done, and shows the pieces.
  RunDialog* makePattern();
  PatternView& pattern() { return *pattern_; }
  const QString& statusText() const { return status_text_; }

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void makeDocks();
  QDockWidget* addDock(const QString& title, QWidget* content);
  void makeActions();
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeToolBar();
  void makeSimulationMenu();
  void makeSettingsMenu();
  QAction* add(QMenu* menu, const QString& text, const QString& keys, const QString& tip,
               const std::function<void()>& act);
  void showStatus();
  void showTitle();
  void showPoses();
  void look(double yaw_deg, double pitch_deg);
  void frameView();
  void compare(ViewWidget::Content content);
  void showPattern(std::shared_ptr<const PatternSheet> sheet);
  void makePatternView();
  void pickOnPaper();
  void pickPart();
  RunDialog* runCommands(const QStringList& commands);
  std::filesystem::path resultsDirectory() const;
  std::filesystem::path folder() const;
  /// Says why where no poses can be added.
  bool mayAddPoses();
  QStringList askForScans(const QString& title);
  QString askForFile(const QString& title, const QString& file, const QString& filter, const QString& suffix);
  void saveAs();
  void exportPicture();
  bool mayDropWork();
  bool mayEndRun();
  /// Shows another document in a new window, which says these words, and closes this one; says why if it cannot be
  /// read.
  bool replaceBy(const std::function<Document()>& read, bool asks, const std::string& words = "");
  void changeRadius(double factor);
  void tick();

  std::unique_ptr<Studio> studio_;
  std::unique_ptr<Tool> tool_;
  QWidget* centre_ = nullptr;
  ViewWidget *view_ = nullptr, *other_ = nullptr;
  PatternView* pattern_ = nullptr;
  ToolPanel* tool_panel_ = nullptr;
  QDockWidget* tool_dock_ = nullptr;
  ClothPanel* cloth_panel_ = nullptr;
  PartsTree* parts_ = nullptr;
  QListWidget* poses_ = nullptr;
  QLabel *report_ = nullptr, *under_ = nullptr, *status_ = nullptr;
  ScenePanel* scene_text_ = nullptr;
  QProgressBar* way_ = nullptr;
  QActionGroup *tools_ = nullptr, *shown_ = nullptr;
  QAction *play_ = nullptr, *adapt_ = nullptr, *tour_ = nullptr, *undo_ = nullptr, *redo_ = nullptr;
  QTimer timer_;
  QElapsedTimer clock_, since_frame_;
  QString status_text_;
  int text_revision_ = -1, mesh_revision_ = -1;
  double steps_per_s_ = 0.0;
  long steps_before_ = 0, drawn_before_ = 0;
  double frames_per_s_ = 0.0;
  bool asks_ = true;  // about unsaved work, on closing
};

}  // namespace ease
