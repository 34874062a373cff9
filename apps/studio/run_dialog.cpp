#include "apps/studio/run_dialog.h"

#include <signal.h>

#include <QCoreApplication>
#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPixmap>
#include <QScreen>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/studio/keep_on_screen.h"

namespace ease {

namespace {

constexpr int kMaxWarnings = 4;  // more are told by their number

}  // namespace

QString RunDialog::program() {
  const QString beside = QCoreApplication::applicationDirPath();
  for (const QString& place : {beside + "/ease", beside + "/../ease", beside + "/../../apps/ease"})
    if (QFileInfo(place).isExecutable() && QFileInfo(place).isFile()) return place;
  return "ease";
}

RunDialog::RunDialog(const QStringList& commands, const QString& scene, const QString& directory, QWidget* parent)
    : QDialog(parent), commands_(commands), scene_(scene), directory_(directory) {
  setWindowTitle(commands.back() == "run" ? "Run" : "Pattern");
  setAttribute(Qt::WA_DeleteOnClose);
  auto* column = new QVBoxLayout(this);
  text_ = new QLabel("Starting ...");
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  picture_ = new QLabel;
  bar_ = new QProgressBar;
  bar_->setRange(0, 0);
  button_ = new QPushButton("Cancel");
  column->addWidget(text_);
  column->addWidget(picture_);
  column->addWidget(bar_);
  go_on_ = new QPushButton("Go on");
  go_on_->setToolTip("Computes on from where it was interrupted");
  page_ = new QPushButton("Open the page");
  page_->setToolTip("The whole result in the browser: pictures, figures by part, charts");
  auto* row = new QHBoxLayout;
  row->addStretch();
  for (QPushButton* button : {go_on_, page_, button_}) row->addWidget(button);
  column->addLayout(row);
  go_on_->hide();
  page_->hide();
  setMinimumWidth(560);
  connect(go_on_, &QPushButton::clicked, this, [this] {
    resumes_ = true;
    clock_.start();
    tick_.start(1000);
    start();
  });
  connect(page_, &QPushButton::clicked, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(directory_ + "/fit.html")); });
  connect(button_, &QPushButton::clicked, this, [this] { isRunning() ? interrupt() : accept(); });
  process_.setProcessChannelMode(QProcess::MergedChannels);
  connect(&process_, &QProcess::readyRead, this, [this] { readProgress(); });
  connect(&process_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
          [this](int code) { finish(code); });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    said_ = "the program '" + program() + "' cannot be started";
    finish(-1);
  });
  connect(&tick_, &QTimer::timeout, this, [this] { readProgress(); });
  clock_.start();
  tick_.start(1000);
  start();
}

void RunDialog::start() {
  said_.clear();
  was_ended_ = false;
  bar_->setRange(0, 0);
  bar_->show();
  go_on_->hide();
  button_->setText("Cancel");
  process_.start(program(),
                 {commands_.front(), scene_, resumes_ && commands_.front() == "run" ? "--resume" : "-o", directory_});
}

RunDialog::~RunDialog() {
  process_.disconnect();
  if (!isRunning()) return;
  interrupt();
  process_.waitForFinished(5000);
}

void RunDialog::interrupt() {
  was_ended_ = true;
  if (process_.processId() > 0) kill(static_cast<pid_t>(process_.processId()), SIGINT);
  text_->setText("Ending; what is written by then can be opened ...");
}

void RunDialog::readProgress() {
  said_ += QString::fromUtf8(process_.readAll());
  const QStringList lines = said_.split('\n', Qt::SkipEmptyParts);
  const QString last = lines.isEmpty() ? QString(commands_.front() == "run" ? "Making the garment and simulating ..."
                                                                            : "Flattening the pieces ...")
                                       : lines.back().simplified();
  bool is_share = false;
  const int share = last.section('%', 0, 0).trimmed().toInt(&is_share);
  if (is_share && last.contains('%')) {
    bar_->setRange(0, 100);
    bar_->setValue(share);
  }
  if (isRunning()) text_->setText(QString("%1\n%2 s so far").arg(last).arg(clock_.elapsed() / 1000));
}

void RunDialog::finish(int code) {
  said_ += QString::fromUtf8(process_.readAll());
  constexpr int kDone = 0, kDoubtful = 3;  // exit codes of ease
  const bool is_done = code == kDone || code == kDoubtful;
  if (is_done && commands_.size() > 1) {
    commands_.removeFirst();
    return start();
  }
  tick_.stop();
  bar_->hide();
  button_->setText("Close");
  was_ended_ = was_ended_ && !is_done;
  go_on_->setVisible(was_ended_ && QFile::exists(directory_ + "/checkpoint.bin"));
  if (is_done || was_ended_) showResult();
  if (is_done) Q_EMIT succeeded();
  if (is_done || was_ended_) return;
  const QStringList lines = said_.split('\n', Qt::SkipEmptyParts);
  text_->setText("It failed: " + (lines.isEmpty() ? QString("exit code %1").arg(code) : lines.back()));
}

/// What report.json says of the garment, and of its pattern where that was made.
QString RunDialog::wordsOfResult() const {
  QString text = "Results in " + directory_;
  QFile file(directory_ + "/report.json");
  if (!file.open(QIODevice::ReadOnly)) return text;
  const QJsonObject report = QJsonDocument::fromJson(file.readAll()).object();
  const auto percent = [](double share) { return QString("%1 %").arg(100.0 * share, 0, 'f', 2); };
  const auto share = [&](const char* which) {
    return report["sigma_1"].toObject()[which].toObject()["share_over_limit"].toDouble(-1.0);
  };
  const QJsonObject sewn = report["pattern"].toObject()["resewn"].toObject();
  if (commands_.front() == "pattern" && !sewn.isEmpty()) {
    text += "\nThe garment sewn from these pieces, from the designed one:";
    const auto add = [&](const QString& where, const QJsonObject& distance) {
      text += QString("\n%1: %2 mm (RMS), %3 mm at most")
                  .arg(where)
                  .arg(distance["rms_mm"].toDouble(), 0, 'f', 1)
                  .arg(distance["max_mm"].toDouble(), 0, 'f', 0);
    };
    const QJsonArray poses = sewn["poses"].toArray();
    if (poses.size() != 1) add("held on the first pose", sewn);
    for (const QJsonValue& pose : poses) add("in pose " + pose["pose"].toString(), pose.toObject());
  }
  if (commands_.front() == "pattern" && sewn["share_over_limit"].isDouble())
    text += "\nTriangles over the limit once sewn: " + percent(sewn["share_over_limit"].toDouble());
  if (commands_.front() == "run" && share("before") >= 0.0 && share("after") >= 0.0)
    text += "\nTriangles over the limit at the worst moment: " + percent(share("before")) + " before, " +
            percent(share("after")) + " after";
  for (const QJsonValue& doubt : report["doubts"].toArray())
    text += "\nThe figures cannot be trusted: " + doubt.toString();
  const QJsonArray warnings =
      (commands_.front() == "run" ? report : report["pattern"].toObject())["warnings"].toArray();
  for (int k = 0; k < std::min<int>(warnings.size(), kMaxWarnings); ++k) text += "\nWarning: " + warnings[k].toString();
  if (warnings.size() > kMaxWarnings)
    text += QString("\n... and %1 warnings more in report.json").arg(warnings.size() - kMaxWarnings);
  return text;
}

void RunDialog::showResult() {
  text_->setText((was_ended_ ? "It was ended before it was done. " : "") + wordsOfResult());
  const QPixmap stretch(directory_ + (commands_.front() == "run" ? "/stretch.png" : "/pattern_resewn.png"));
  const int words = text_->heightForWidth(minimumWidth()) + 9 * fontMetrics().height();  // buttons and frame, too
  const QSize room = (screen()->availableGeometry().size() - QSize(100, words)).boundedTo({960, 600});
  if (!stretch.isNull())
    picture_->setPixmap(stretch.scaled(room * devicePixelRatioF(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
  page_->setVisible(QFileInfo::exists(directory_ + "/fit.html"));
  layout()->activate();
  const int width = sizeHint().width();  // adjustSize() would stop at two thirds of the screen
  resize(width, std::max(sizeHint().height(), heightForWidth(width)));
  keepOnScreen(*this);
}

}  // namespace ease
