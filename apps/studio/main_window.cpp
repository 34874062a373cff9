#include "apps/studio/main_window.h"

#include <Eigen/Geometry>
#include <QHBoxLayout>
#include <QStatusBar>
#include <algorithm>

#include "apps/studio/report_text.h"

namespace ease {

namespace {

constexpr int kTick = 15;               // ms, between looks for news
constexpr double kDrawingShare = 0.12;  // of the time while simulating, but see kSlowest
constexpr double kFastest = 33.0;       // ms between two pictures
constexpr double kSlowest = 90.0;       // ms between two pictures at most, unless a picture takes half of that
constexpr int kReportTick = 500;        // ms

}  // namespace

MainWindow::MainWindow(Document document) {
  resize(1280, 800);
  centre_ = new QWidget;
  auto* row = new QHBoxLayout(centre_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  setCentralWidget(centre_);
  status_ = new QLabel;
  status_->setWordWrap(true);
  status_->setFixedHeight(2 * fontMetrics().height() + 2);
  status_->setMinimumWidth(100);
  way_ = new QProgressBar;
  way_->setRange(0, 100);
  way_->setFixedWidth(8 * fontMetrics().height());
  way_->setFormat("to the pose: %p %");
  statusBar()->addWidget(status_, 1);
  statusBar()->addPermanentWidget(way_);
  studio_ = std::make_unique<Studio>(std::move(document));
  view_ = new ViewWidget(*studio_, ViewWidget::Content::simulated);
  other_ = new ViewWidget(*studio_, ViewWidget::Content::rest);
  other_->hide();
  row->addWidget(view_, 1);
  row->addWidget(other_, 1);
  makePatternView();
  row->addWidget(pattern_, 1);
  makeDocks();
  makeActions();
  const auto used = [this] {
    tool_panel_->showSettings();
    if (const std::optional<Part> part = tool_->takePicked()) parts_->select(part);
    sync();
  };
  connect(view_, &ViewWidget::used, this, used);
  connect(view_, &ViewWidget::pointedAt, this, [this](const QString& words) { under_->setText(words); });
  connect(view_, &ViewWidget::cameraChanged, this, [this] { other_->refresh(); });
  connect(other_, &ViewWidget::cameraChanged, this, [this] { view_->refresh(); });
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  clock_.start();
  since_frame_.start();
  timer_.start(kTick);
  chooseTool(PartKind::boundary);
  frameView();
  QTimer::singleShot(0, this, [this] { showPoses(); });
  sync();
}

MainWindow::~MainWindow() {
  timer_.stop();
}

void MainWindow::chooseTool(PartKind kind) {
  view_->setTool(nullptr);
  tool_ = makeTool(kind, *studio_);
  view_->setTool(tool_.get());
  tool_panel_->setTool(kind);
  tool_dock_->setWindowTitle(QString("Tool: ") + textOf(kind).name);
  tools_->actions()[static_cast<int>(kind)]->setChecked(true);
  studio_->say(tool_->hint());
  sync();
}

void MainWindow::tick() {
  const double draw_ms = 1000.0 * view_->drawSeconds();
  const double pause_ms = std::clamp(draw_ms / kDrawingShare, kFastest, std::max(kSlowest, 2.0 * draw_ms));
  if (studio_->simulation().plays() && static_cast<double>(since_frame_.elapsed()) >= pause_ms) {
    studio_->simulation().wantFrame(view_->shown() == Shown::pressure || view_->shown() == Shown::ease);
    since_frame_.restart();
  }
  if (studio_->poll()) {
    view_->refresh();
    if (other_->isVisible()) other_->refresh();
    sync();
  }
  if (clock_.elapsed() < kReportTick) return;
  const double seconds = 0.001 * static_cast<double>(clock_.restart());
  const long made = studio_->simulation().stepsMade(), drawn = view_->drawn();
  steps_per_s_ = static_cast<double>(made - steps_before_) / seconds;
  frames_per_s_ = static_cast<double>(drawn - drawn_before_) / seconds;
  steps_before_ = made;
  drawn_before_ = drawn;
  view_->tellPointedAt();
  report_->setText(studio_->frame()      ? reportText(*studio_->frame(), steps_per_s_, frames_per_s_)
                   : studio_->isMaking() ? "The garment is being made ..."
                                         : "No garment yet.");
}

void MainWindow::sync() {
  if (text_revision_ != studio_->textRevision()) {
    text_revision_ = studio_->textRevision();
    parts_->list();
    cloth_panel_->showScene();
    scene_text_->show(QString::fromStdString(studio_->text()));
    showTitle();
  }
  if (mesh_revision_ != studio_->meshRevision()) {
    mesh_revision_ = studio_->meshRevision();
    view_->refresh();
    other_->refresh();
  }
  play_->setChecked(studio_->simulation().plays());
  adapt_->setChecked(studio_->adapts());
  tour_->setChecked(studio_->isOnTour());
  if (poses_->currentRow() != studio_->pose()) poses_->setCurrentRow(studio_->pose());
  undo_->setEnabled(studio_->document().canUndo() || (tool_ && tool_->isDrawing()));
  redo_->setEnabled(studio_->document().canRedo());
  showStatus();
}

void MainWindow::showStatus() {
  const QString text = QString::fromStdString(studio_->words());
  const double way = studio_->frame() ? studio_->frame()->way : 1.0;
  way_->setVisible(way < 1.0);
  way_->setValue(static_cast<int>(100.0 * way));
  if (text == status_text_ && status_->property("refusal").toBool() == studio_->isRefusal()) return;
  status_text_ = text;
  status_->setProperty("refusal", studio_->isRefusal());
  status_->setStyleSheet(studio_->isRefusal() ? "color: #a02000; font-weight: bold" : "");
  status_->setText((studio_->isRefusal() ? QString::fromUtf8("✕ ") : QString()) + text);
  status_->setToolTip(text);
}

void MainWindow::showTitle() {
  setWindowTitle(QString("%1%2 - Ease Studio")
                     .arg(QString::fromStdString(studio_->document().file().filename().string()),
                          studio_->document().isSaved() ? "" : "*"));
}

void MainWindow::showPoses() {
  poses_->clear();
  for (size_t k = 0; k < studio_->bodyInput().pose_names.size(); ++k)
    poses_->addItem(new QListWidgetItem(QIcon(QPixmap::fromImage(view_->poseImage(static_cast<int>(k)))),
                                        QString::fromStdString(studio_->bodyInput().pose_names[k])));
  view_->refresh();
}

void MainWindow::look(double yaw_deg, double pitch_deg) {
  studio_->stage.camera.yaw_deg = yaw_deg;
  studio_->stage.camera.pitch_deg = pitch_deg;
  view_->refresh();
  other_->refresh();
}

void MainWindow::frameView() {
  const Stage& stage = studio_->stage;
  Eigen::AlignedBox3d box;
  const auto add = [&box](const Positions& x) {
    box.extend(Vec3(x.colwise().minCoeff()));
    box.extend(Vec3(x.colwise().maxCoeff()));
  };
  if (stage.hasCloth() && parts_->selected())
    add(stage.cloth());
  else  // room for all poses, so that raised arms do not leave the view
    for (const Positions& pose : studio_->bodyInput().poses) add(pose);
  studio_->stage.camera.frame(box.min(), box.max(), {std::max(1, view_->width()), std::max(1, view_->height())});
  view_->refresh();
  other_->refresh();
}

void MainWindow::compare(ViewWidget::Content content) {
  const bool hides = content == ViewWidget::Content::simulated;
  if (!hides) other_->setContent(content);
  pattern_->hide();
  other_->setVisible(!hides);
  other_->refresh();
}

void MainWindow::changeRadius(double factor) {
  studio_->settings.radius = std::clamp(studio_->settings.radius * factor, 0.005, 1.0);
  tool_panel_->showSettings();
  studio_->say(tool_->hint());
  view_->refresh();
  sync();
}

}  // namespace ease
