// SPDX-License-Identifier: BSD-3-Clause
#include "panels/ProbePanel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "common/Wording.h"
#include "view/Marks.h"

namespace studio
{
namespace
{
QString metres(double length)
{
  return length < 0.01 ? ProbePanel::tr("%1 mm").arg(1000 * length, 0, 'g', 3)
                       : ProbePanel::tr("%1 m").arg(length, 0, 'g', 3);
}

QString describe(const NearestEdge& edge)
{
  return (edge.contact ? ProbePanel::tr("%1 from a contact of %2°") : ProbePanel::tr("%1 from an edge of %2°"))
      .arg(metres(edge.distance))
      .arg(edge.angle, 0, 'f', edge.angle == std::round(edge.angle) ? 0 : 1);
}
}  // namespace

ProbePanel::ProbePanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  this->Value = new QLabel;
  this->Value->setObjectName(QStringLiteral("probeValue"));
  QFont large = this->Value->font();
  large.setPointSizeF(1.5 * large.pointSizeF());
  this->Value->setFont(large);
  this->Place = new QLabel;
  this->Place->setObjectName(QStringLiteral("probePlace"));
  this->Place->setWordWrap(true);
  this->Convergence = new ChartView;
  this->Histogram = new ChartView;
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->Value);
  layout->addWidget(this->Place);
  layout->addWidget(this->Convergence, 3);
  layout->addWidget(this->Histogram, 2);
  connect(&this->Point, &Probe::changed, this, &ProbePanel::show);
  connect(&this->Point, &Probe::problem, bench, &Workbench::problem);
  connect(bench, &Workbench::sceneChanged, this, &ProbePanel::clear);
  this->show();
}

void ProbePanel::clear()
{
  this->Point.forget();
  this->show();
}

void ProbePanel::probe(const Pick& pick)
{
  this->Point.start(this->Bench->scene(), pick, this->Bench->settings());
  emit this->marked(crossAt(pick.position, 0.012 * this->Bench->scene()->size()));
}

void ProbePanel::show()
{
  const auto estimate = this->Point.estimate();
  if (estimate)
    this->Value->setText(estimate->dark()
                             ? tr("0 lx")
                             : tr("%1 ± %2 lx").arg(estimate->value, 0, 'g', 4).arg(estimate->error, 0, 'g', 2));
  else
    this->Value->setText(this->Point.pick() ? tr("…") : QString());
  QStringList about;
  if (const auto& pick = this->Point.pick())
  {
    about << tr("%1 at (%2, %3, %4) m")
                 .arg(pick->set)
                 .arg(pick->position[0], 0, 'f', 3)
                 .arg(pick->position[1], 0, 'f', 3)
                 .arg(pick->position[2], 0, 'f', 3);
    if (this->Point.edge())
      about << describe(*this->Point.edge());
  }
  if (estimate && estimate->dark())
    about << tr("no trajectory has brought light here: the error is not known");
  else if (estimate)
    about << (estimate->trusted ? tr("the standard error can be trusted")
                                : tr("the standard error cannot be trusted: single scores carry the estimate"));
  this->Place->setText(about.join(QLatin1Char('\n')));
  this->Convergence->setChart(this->Point.convergence());
  this->Histogram->setChart(this->Point.histogram());
}

LinePanel::LinePanel(Workbench* bench, QWidget* parent) : QWidget(parent), Bench(bench)
{
  this->About = new QLabel;
  this->About->setObjectName(QStringLiteral("lineAbout"));
  this->About->setWordWrap(true);
  this->Measure = new QPushButton(tr("Measure across the edge, all methods"));
  this->Measure->setObjectName(QStringLiteral("measure"));
  this->Measure->setToolTip(
      tr("Runs every method at points on the line, a tenth of a millimetre from the edge and on"));
  this->Stop = new QPushButton(tr("Stop"));
  this->Stop->setToolTip(tr("Stops and keeps the methods that are done"));
  this->Against = new ChartView;
  this->Against->setObjectName(QStringLiteral("lineChart"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(this->Measure, 1);
  buttons->addWidget(this->Stop);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->About);
  layout->addLayout(buttons);
  layout->addWidget(this->Against, 1);
  connect(this->Measure, &QPushButton::clicked, this, &LinePanel::measure);
  connect(this->Stop, &QPushButton::clicked, this, [this] { this->Line.cancel(); });
  connect(&this->Line, &LineProbe::changed, this, &LinePanel::show);
  connect(&this->Line, &LineProbe::problem, bench, &Workbench::problem);
  connect(bench, &Workbench::sceneChanged, this, &LinePanel::clear);
  this->show();
}

void LinePanel::clear()
{
  this->Line.forget();
  this->Aim.reset();
  this->show();
}

void LinePanel::aim(const Pick& pick)
{
  this->Aim = lineAcrossEdge(this->Bench->scene(), pick);
  if (this->Aim)
    emit this->marked({{this->Aim->edge.foot, this->Aim->points.last()}});
  this->show();
}

void LinePanel::measure()
{
  this->Line.start(this->Bench->scene(), *this->Aim, this->Bench->settings());
}

void LinePanel::show()
{
  this->Measure->setEnabled(this->Aim.has_value() && !this->Line.active());
  this->Stop->setEnabled(this->Line.active());
  if (this->Line.active())
    this->About->setText(tr("Method %1 of %2").arg(this->Line.finished() + 1).arg(this->Line.count()));
  else if (this->Aim)
    this->About->setText(tr("%1 points from %2 to %3")
                             .arg(this->Aim->points.size())
                             .arg(metres(this->Aim->distances.first()),
                                  describe(this->Aim->edge)
                                      .replace(metres(this->Aim->edge.distance), metres(this->Aim->distances.last()))));
  else
    this->About->setText(tr("Click a surface near an edge to choose the line."));
  this->Against->setChart(this->Line.chart());
}
}  // namespace studio
