// Does what `ease run` and `ease pattern` do, as processes of their own, and shows the result.
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
  /// Starts `ease` with these words ("run", "pattern"), one after the other, of a scene file; results go to
  /// `directory`.
  RunDialog(const QStringList& commands, const QString& scene, const QString& directory, QWidget* parent = nullptr);
  ~RunDialog() override;

  bool isRunning() const { return process_.state() != QProcess::NotRunning; }
  QString text() const { return text_->text(); }
  /// As Ctrl+C does; what is written by then can be opened.
  void interrupt();

  /// The program `ease` beside this one.
  static QString program();

 Q_SIGNALS:
  /// The last command has ended: everything is written.
  void succeeded();

 private:
  void start();
  void readProgress();
  void finish(int code);
  void showResult();
  QString wordsOfResult() const;

  QStringList commands_;  // still to be done; the first is running
  QString scene_, directory_, said_;
  QProcess process_;
  QElapsedTimer clock_;
  QTimer tick_;
  QLabel *text_, *picture_;
  QProgressBar* bar_;
  QPushButton *button_, *go_on_, *page_;
  bool resumes_ = false, was_ended_ = false;
};

}  // namespace ease
