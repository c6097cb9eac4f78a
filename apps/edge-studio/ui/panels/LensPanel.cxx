// SPDX-License-Identifier: BSD-3-Clause
#include "panels/LensPanel.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>

#include "common/Wording.h"
#include "results/Colours.h"

namespace studio
{
namespace
{
constexpr double limit = 0.5;  // of the scale of relative errors

QString describe(const EdgePiece& edge)
{
  return (edge.contact ? LensPanel::tr("Contact of %1°, %2 m long, severity %3")
                       : LensPanel::tr("Edge of %1°, %2 m long, severity %3"))
      .arg(edge.angle, 0, 'f', 0)
      .arg(edge.length(), 0, 'f', 2)
      .arg(edge.severity, 0, 'g', 2);
}

LegendBar* legendBar(const QString& name, const Legend& legend)
{
  auto* bar = new LegendBar(Qt::Horizontal);
  bar->setObjectName(name);
  bar->setLegend(legend);
  return bar;
}
}  // namespace

LensView::LensView(const EdgeLens* lens, QWidget* parent) : QWidget(parent), Lens(lens)
{
  this->setMinimumSize(260, 200);
}

QImage LensView::heatMap(int method) const
{
  const QVector<double> errors = this->Lens->grid() ? this->Lens->errors(method) : QVector<double>();
  if (errors.isEmpty())
    return {};
  const auto colours = differenceColours(limit);
  QImage image(2 * LensGrid::columns, LensGrid::rows, QImage::Format_RGB32);
  for (int face = 0; face < 2; ++face)
    for (int row = 0; row < LensGrid::rows; ++row)
      for (int column = 0; column < LensGrid::columns; ++column)
      {
        const int point = this->Lens->grid()->at(face, row, column);
        const int x = face == 0 ? LensGrid::columns - 1 - column : LensGrid::columns + column;
        const unsigned char grey[] = {0xb0, 0xb0, 0xb0}, *c = point < 0 ? grey : colours->MapValue(errors[point]);
        image.setPixel(x, row, qRgb(c[0], c[1], c[2]));
      }
  return image;
}

void LensView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), Qt::white);
  const double line = this->fontMetrics().lineSpacing(), names = 9 * line, right = this->width() - 0.5 * line,
               height = (this->height() - 1.5 * line) / methods().size();
  const double step = (right - names) / (2 * LensGrid::columns);
  double top = 0;
  for (const Method& method : methods())
  {
    painter.drawText(QRectF(0.5 * line, top, names - line, height), Qt::AlignRight | Qt::AlignVCenter,
                     QString::fromLatin1(method.key));
    const QRectF place(names, top + 1, right - names, height - 2);
    const QImage image = this->heatMap(method.id);
    image.isNull() ? painter.fillRect(place, QColor(0xee, 0xee, 0xf0)) : painter.drawImage(place, image);
    top += height;
  }
  painter.drawLine(QPointF((names + right) / 2, 0), QPointF((names + right) / 2, top));
  for (int face = 0; face < 2; ++face)
    for (int column : {10, 30})
    {
      const double at =
          (face == 0 ? LensGrid::columns - 0.5 - column : LensGrid::columns + 0.5 + column) * step + names;
      const double metres = LensGrid::distance(column);
      const QString text = metres < 0.01 ? LensPanel::tr("%1 mm").arg(1000 * metres, 0, 'g', 2)
                                         : LensPanel::tr("%1 cm").arg(100 * metres, 0, 'g', 2);
      painter.drawText(QRectF(at - 2 * line, top, 4 * line, 1.4 * line), Qt::AlignCenter, text);
    }
}

LensPanel::LensPanel(Workbench* bench, SceneView* view, QWidget* parent) : QWidget(parent), Bench(bench), View(view)
{
  this->Edges = new QListWidget;
  this->Edges->setObjectName(QStringLiteral("lensEdges"));
  this->Edges->setToolTip(tr("Singular edges, the most severe first. Choose one to look at it."));
  this->Edges->setMaximumHeight(7 * this->fontMetrics().lineSpacing());
  this->Effort = new QSlider(Qt::Horizontal);
  this->Effort->setObjectName(QStringLiteral("lensEffort"));
  this->Effort->setRange(6, 16);
  this->Effort->setValue(10);
  this->Effort->setToolTip(tr("Trajectories of each method; δ, ε and the seed are those of the panel Method"));
  this->EffortText = new QLabel;
  this->Measure = new QPushButton(tr("Measure both faces, all methods"));
  this->Measure->setObjectName(QStringLiteral("lensMeasure"));
  this->Measure->setToolTip(tr("Runs every method on both faces, a tenth of a millimetre from the edge and on"));
  this->Stop = new QPushButton(tr("Stop"));
  this->Stop->setToolTip(tr("Stops and keeps the methods that are done"));
  this->About = new QLabel;
  this->About->setObjectName(QStringLiteral("lensAbout"));
  this->About->setWordWrap(true);
  this->Picture = new LensView(&this->Lens);
  auto* effort = new QHBoxLayout;
  effort->addWidget(this->EffortText);
  effort->addWidget(this->Effort, 1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(this->Measure, 1);
  buttons->addWidget(this->Stop);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(
      legendBar(QStringLiteral("severityLegend"), {severityColours(), tr("Severity of edges"), {}, {}, {}}));
  layout->addWidget(this->Edges);
  layout->addLayout(effort);
  layout->addLayout(buttons);
  layout->addWidget(this->About);
  layout->addWidget(this->Picture, 1);
  layout->addWidget(
      legendBar(QStringLiteral("lensLegend"), {differenceColours(limit), tr("Relative error"), {}, {}, {}}));
  connect(bench, &Workbench::sceneChanged, this, &LensPanel::listEdges);
  connect(this->Edges, &QListWidget::currentRowChanged, this, &LensPanel::choose);
  connect(this->Effort, &QSlider::valueChanged, this, &LensPanel::show);
  connect(this->Measure, &QPushButton::clicked, this, &LensPanel::measure);
  connect(this->Stop, &QPushButton::clicked, this, [this] { this->Lens.cancel(); });
  connect(&this->Lens, &EdgeLens::changed, this, &LensPanel::show);
  connect(&this->Lens, &EdgeLens::problem, bench, &Workbench::problem);
  this->show();
}

void LensPanel::listEdges()
{
  this->Lens.forget();
  this->Chosen.reset();
  const QSignalBlocker blocker(this->Edges);
  this->Edges->clear();
  this->Pieces = edgePieces(*this->Bench->scene()).mid(0, 200);
  for (const EdgePiece& piece : this->Pieces)
    this->Edges->addItem(describe(piece));
  this->Edges->setCurrentRow(-1);
  this->show();
}

void LensPanel::choose(int row)
{
  if (row < 0 || row >= this->Pieces.size())
    return;
  this->Lens.forget();
  this->Chosen = lensGrid(this->Bench->scene(), this->Pieces[row]);
  if (this->Chosen)
  {
    this->lookAtEdge();
    emit this->marked({{this->Chosen->edge.from, this->Chosen->edge.to}});
  }
  this->show();
}

// From between the two faces, so that both are seen; not from beyond a plane, which would hide them.
void LensPanel::lookAtEdge()
{
  const EdgePiece& edge = this->Chosen->edge;
  const ScenePtr& scene = this->Bench->scene();
  const Point back = (this->Chosen->flanks[0].away + this->Chosen->flanks[1].away).Normalized(),
              along = (edge.to - edge.from).Normalized(), way = (back + 0.2 * along).Normalized();
  const double wanted = std::max(1.2 * edge.length(), 0.1 * scene->size());
  const Point start = edge.middle() + 1e-3 * scene->size() * way;
  double away = wanted;
  for (const QString& set : scene->sets())
    if (const auto hit = Picking(scene, {set}).first(start, edge.middle() + 1.1 * wanted * way))
      away = std::min(away, 0.9 * (hit->position - edge.middle()).Norm());
  CameraPreset camera;
  camera.target = edge.middle();
  camera.position = edge.middle() + away * way;
  camera.up = std::abs(way[2]) < 0.95 ? Point(0, 0, 1) : Point(0, 1, 0);
  this->View->look(camera);
}

void LensPanel::measure()
{
  MethodSettings settings = this->Bench->settings();
  settings.goal = Goal::Trajectories;
  settings.trajectories = 1LL << this->Effort->value();
  this->Lens.start(this->Bench->scene(), *this->Chosen, settings);
}

void LensPanel::show()
{
  this->EffortText->setText(tr("N %1").arg(grouped(1LL << this->Effort->value())));
  this->Measure->setEnabled(this->Chosen.has_value() && !this->Lens.active());
  this->Stop->setEnabled(this->Lens.active());
  if (this->Chosen)
    this->About->setText(tr("%1 points from 0.1 mm to 1 m on both sides of the edge").arg(this->Chosen->points.size()));
  else if (this->Edges->currentRow() >= 0)
    this->About->setText(tr("The faces beside this edge were not found."));
  else
    this->About->setText(tr("Choose an edge of the list."));
  this->Picture->update();
}
}  // namespace studio
