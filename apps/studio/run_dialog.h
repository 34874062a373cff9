// Does what `ease run` does, as a process of its own, and shows its result.
#pragma once

#include <QDialog>
#include <QElapsedTimer>
#include <QLabel>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

namespace ease {

class RunDialog : public QDialog {
  Q_OBJECT

 public:
  /// Starts the run of a scene file; its results go to `directory`.
  RunDialog(const QString& scene, const QString& directory, QWidget* parent = nullptr);
  ~RunDialog() override;

  bool isRunning() const { return process_.state() != QProcess::NotRunning; }
  /// As Ctrl+C does; what is written by then can be opened.
  void interrupt();

  /// The program `ease` beside this one.
  static QString program();

 private:
  void readProgress();
  void finish(int code);
  void showResult();

  QString directory_, said_;
  QProcess process_;
  QElapsedTimer clock_;
  QTimer tick_;
  QLabel *text_, *picture_;
  QProgressBar* bar_;
  QPushButton* button_;
};

}  // namespace ease
