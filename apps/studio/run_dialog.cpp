#include "apps/studio/run_dialog.h"

#include <signal.h>

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPixmap>
#include <QVBoxLayout>

namespace ease {

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
  column->addWidget(button_, 0, Qt::AlignRight);
  setMinimumWidth(560);
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
  bar_->setRange(0, 0);
  process_.start(program(), {commands_.front(), scene_, "-o", directory_});
}

RunDialog::~RunDialog() {
  process_.disconnect();
  if (!isRunning()) return;
  interrupt();
  process_.waitForFinished(5000);
}

void RunDialog::interrupt() {
  if (process_.processId() > 0) kill(static_cast<pid_t>(process_.processId()), SIGINT);
  text_->setText("Ending; what is written by then can be opened ...");
}

void RunDialog::readProgress() {
  said_ += QString::fromUtf8(process_.readAll());
  const QStringList lines = said_.split('\n', Qt::SkipEmptyParts);
  const QString last = lines.isEmpty() ? QString("Making the garment and simulating ...") : lines.back().trimmed();
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
  constexpr int kDone = 0, kDoubtful = 3, kInterrupted = 130;  // exit codes of ease
  const bool is_done = code == kDone || code == kDoubtful;
  if (is_done && commands_.size() > 1) {
    commands_.removeFirst();
    return start();
  }
  tick_.stop();
  bar_->hide();
  button_->setText("Close");
  if (is_done || code == kInterrupted) showResult();
  if (is_done) Q_EMIT succeeded();
  if (is_done || code == kInterrupted) return;
  const QStringList lines = said_.split('\n', Qt::SkipEmptyParts);
  text_->setText("It failed: " + (lines.isEmpty() ? QString("exit code %1").arg(code) : lines.back()));
}

void RunDialog::showResult() {
  QFile file(directory_ + "/report.json");
  QString text = "Results in " + directory_;
  if (file.open(QIODevice::ReadOnly)) {
    const QJsonObject report = QJsonDocument::fromJson(file.readAll()).object();
    const auto share = [&](const char* which) {
      return 100.0 * report["sigma_1"].toObject()[which].toObject()["share_over_limit"].toDouble(-0.01);
    };
    if (share("before") >= 0.0 && share("after") >= 0.0)
      text += QString("\nTriangles over the limit at the worst moment: %1 % before, %2 % after")
                  .arg(share("before"), 0, 'f', 2)
                  .arg(share("after"), 0, 'f', 2);
    for (const QJsonValue& doubt : report["doubts"].toArray()) text += "\nThe figures say nothing: " + doubt.toString();
    if (report["interrupted"].toBool()) text += "\nIt was interrupted; `ease run --resume` goes on from there.";
  }
  text_->setText(text);
  const QPixmap stretch(directory_ + (commands_.front() == "run" ? "/stretch.png" : "/pattern_resewn.png"));
  if (!stretch.isNull())
    picture_->setPixmap(stretch.scaled(int(960 * devicePixelRatioF()), int(600 * devicePixelRatioF()),
                                       Qt::KeepAspectRatio, Qt::SmoothTransformation));
  adjustSize();
}

}  // namespace ease
