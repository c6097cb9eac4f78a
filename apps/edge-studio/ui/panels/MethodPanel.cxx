// SPDX-License-Identifier: BSD-3-Clause
#include "panels/MethodPanel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "common/Wording.h"

namespace studio
{
namespace
{
QDoubleSpinBox* lengthBox(const QString& name, const QString& tip)
{
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(0, 100);
  box->setDecimals(4);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setSuffix(QStringLiteral(" m"));
  box->setSpecialValueText(MethodPanel::tr("auto"));
  box->setToolTip(tip);
  return box;
}
}  // namespace

MethodPanel::MethodPanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->addLayout(this->makeForm());

  auto* buttons = new QHBoxLayout;
  auto button = [&](const QString& text, const QString& name, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setToolTip(tip);
    buttons->addWidget(made);
    return made;
  };
  this->RunButton = button(tr("Run"), QStringLiteral("run"), tr("Computes the ticked sets of points (F5)"));
  this->RunButton->setDefault(true);
  this->PauseButton = button(tr("Pause"), QStringLiteral("pause"), tr("Pauses the run, or continues it (F6)"));
  this->CancelButton =
      button(tr("Cancel"), QStringLiteral("cancel"), tr("Stops the run and keeps what it has found (Esc)"));
  layout->addLayout(buttons);

  this->Progress = new QProgressBar;
  this->Progress->setRange(0, 1000);
  this->Progress->setTextVisible(false);
  this->Progress->setFixedHeight(6);
  layout->addWidget(this->Progress);
  this->Times = new QLabel;
  this->Times->setObjectName(QStringLiteral("times"));
  this->Errors = new QLabel;
  this->Errors->setObjectName(QStringLiteral("errors"));
  this->Errors->setWordWrap(true);
  this->Errors->setToolTip(
      tr("The standard error is the root mean square of the relative standard errors over all lit "
         "points. A point is not to be trusted where a few scores dominate its estimate."));
  this->Errors->setMinimumHeight(3 * this->fontMetrics().lineSpacing());
  this->Errors->setAlignment(Qt::AlignTop);
  layout->addWidget(this->Times);
  layout->addWidget(this->Errors);
  layout->addStretch(1);

  connect(this->RunButton, &QPushButton::clicked, bench, &Workbench::run);
  connect(this->PauseButton, &QPushButton::clicked, this, &MethodPanel::togglePause);
  connect(this->CancelButton, &QPushButton::clicked, bench, &Workbench::cancel);
  connect(bench, &Workbench::settingsChanged, this, &MethodPanel::readSettings);
  connect(bench, &Workbench::runChanged, this, &MethodPanel::showRun);
  connect(bench, &Workbench::resultsChanged, this, &MethodPanel::showRun);
  connect(&this->Tick, &QTimer::timeout, this, &MethodPanel::showRun);
  this->readSettings();
  this->showRun();
}

QFormLayout* MethodPanel::makeForm()
{
  this->MethodBox = new QComboBox;
  this->MethodBox->setObjectName(QStringLiteral("method"));
  for (const Method& method : methods())
  {
    this->MethodBox->addItem(QString::fromLatin1(method.key), method.id);
    this->MethodBox->setItemData(this->MethodBox->count() - 1, explain(method.id), Qt::ToolTipRole);
  }
  this->GoalBox = new QComboBox;
  this->GoalBox->setObjectName(QStringLiteral("goal"));
  this->GoalBox->addItems({tr("Trajectories"), tr("Error, 95 %"), tr("Time")});
  this->GoalBox->setToolTip(
      tr("When a run ends: after so many trajectories, when every 95 % half-width is within an "
         "error, or after a time"));
  this->Amount = new QDoubleSpinBox;
  this->Amount->setToolTip(tr("How many, how exact or how long"));
  this->Amount->setObjectName(QStringLiteral("amount"));
  this->Amount->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  this->Delta = lengthBox(QStringLiteral("delta"), tr("Distance below which the kernel is averaged or clamped"));
  this->Epsilon = lengthBox(QStringLiteral("epsilon"), tr("Radius that the kernel is averaged over"));
  this->Seed = new QSpinBox;
  this->Seed->setObjectName(QStringLiteral("seed"));
  this->Seed->setRange(0, 1000000000);
  this->Seed->setToolTip(tr("The same seed gives the same numbers"));

  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Method"), this->MethodBox);
  form->addRow(tr("&Until"), this->GoalBox);
  form->addRow(QString(), this->Amount);
  form->addRow(tr("δ"), this->Delta);
  form->addRow(tr("ε"), this->Epsilon);
  form->addRow(tr("&Seed"), this->Seed);

  connect(this->MethodBox, qOverload<int>(&QComboBox::activated), this, &MethodPanel::writeSettings);
  connect(this->GoalBox, qOverload<int>(&QComboBox::activated), this, [this](int goal) {
    MethodSettings settings = this->Bench->settings();
    settings.goal = static_cast<Goal>(goal);
    this->Bench->setSettings(settings);
  });
  for (QDoubleSpinBox* box : {this->Amount, this->Delta, this->Epsilon})
  {
    box->setKeyboardTracking(false);
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &MethodPanel::writeSettings);
  }
  this->Seed->setKeyboardTracking(false);
  connect(this->Seed, qOverload<int>(&QSpinBox::valueChanged), this, &MethodPanel::writeSettings);
  return form;
}

void MethodPanel::readSettings()
{
  const MethodSettings& s = this->Bench->settings();
  const QSignalBlocker a(this->Amount), d(this->Delta), e(this->Epsilon), k(this->Seed);
  this->MethodBox->setCurrentIndex(this->MethodBox->findData(s.method));
  this->MethodBox->setToolTip(explain(s.method));
  this->GoalBox->setCurrentIndex(static_cast<int>(s.goal));
  switch (s.goal)
  {
    case Goal::Trajectories:
      this->Amount->setDecimals(0);
      this->Amount->setRange(1, 1e12);
      this->Amount->setSuffix(QString());
      this->Amount->setValue(static_cast<double>(s.trajectories));
      break;
    case Goal::Error:
      this->Amount->setDecimals(2);
      this->Amount->setRange(0.01, 99);
      this->Amount->setSuffix(QStringLiteral(" %"));
      this->Amount->setValue(100 * s.relativeError);
      break;
    case Goal::Time:
      this->Amount->setDecimals(1);
      this->Amount->setRange(0.1, 1e6);
      this->Amount->setSuffix(QStringLiteral(" s"));
      this->Amount->setValue(s.seconds);
      break;
  }
  this->Delta->setValue(s.delta);
  this->Epsilon->setValue(s.epsilon);
  this->Delta->setEnabled(methodOf(s.method).usesDelta);
  this->Epsilon->setEnabled(methodOf(s.method).usesEpsilon);
  this->Seed->setValue(static_cast<int>(s.seed));
}

void MethodPanel::writeSettings()
{
  MethodSettings s = this->Bench->settings();
  s.method = this->MethodBox->currentData().toInt();
  switch (s.goal)
  {
    case Goal::Trajectories:
      s.trajectories = std::llround(this->Amount->value());
      break;
    case Goal::Error:
      s.relativeError = this->Amount->value() / 100;
      break;
    case Goal::Time:
      s.seconds = this->Amount->value();
      break;
  }
  s.delta = this->Delta->value();
  s.epsilon = this->Epsilon->value();
  s.seed = this->Seed->value();
  this->Bench->setSettings(s);
}

void MethodPanel::togglePause()
{
  Run* run = this->Bench->activeRun();
  if (!run)
    return;
  run->state() == Run::State::Paused ? run->resume() : run->pause();
  this->showRun();
}

void MethodPanel::showRun()
{
  const Run* run = this->Bench->activeRun();
  const bool active = this->Bench->isRunning(), paused = active && run->state() == Run::State::Paused;
  this->RunButton->setEnabled(this->Bench->scene() != nullptr && !this->Bench->isBusy());
  this->PauseButton->setEnabled(active);
  this->PauseButton->setText(paused ? tr("Continue") : tr("Pause"));
  this->CancelButton->setEnabled(active);
  // Software OpenGL redraws the whole window whenever a label changes.
  active && !paused ? this->Tick.start(std::max(250, this->Bench->redrawWait())) : this->Tick.stop();
  this->Progress->setValue(run ? static_cast<int>(1000 * run->progress()) : 0);
  this->Times->setText(run ? describeTimes(*run) : QString());
  this->Errors->setText(run && run->result() ? describeQuality(*run->result()) : QString());
}
}  // namespace studio
