// SPDX-License-Identifier: BSD-3-Clause
#include "panels/StudyPanel.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <cmath>

#include "common/Wording.h"
#include "view/Pictures.h"

namespace studio
{
namespace
{
constexpr int pictureSize = 132;

/// "+0.26 %"
QString signedPercent(double fraction)
{
  return (fraction < 0 ? QStringLiteral("−") : QStringLiteral("+")) + percent(std::abs(fraction));
}

QString listText(const QVector<double>& numbers)
{
  QStringList parts;
  for (double number : numbers)
    parts << (number > 0 ? QString::number(number, 'g', 12) : QStringLiteral("auto"));
  return parts.join(QStringLiteral(", "));
}

/// The picture above, the figures below.
class PictureDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
  {
    QStyledItemDelegate::initStyleOption(option, index);
    option->decorationPosition = QStyleOptionViewItem::Top;
    option->displayAlignment = Qt::AlignHCenter | Qt::AlignTop;
  }
};

QLineEdit* listEdit(const QString& name, const QString& text, const QString& tip)
{
  auto* edit = new QLineEdit(text);
  edit->setObjectName(name);
  edit->setToolTip(tip);
  return edit;
}
}  // namespace

QVector<double> numberList(const QString& text, bool allowAuto)
{
  QVector<double> numbers;
  for (const QString& part : text.split(QLatin1Char(',')))
  {
    bool good = true;
    const bool automatic = allowAuto && part.trimmed() == QStringLiteral("auto");
    const double number = automatic ? 0 : QLocale::c().toDouble(part.trimmed(), &good);
    if (!good || (!automatic && !(number > 0 && std::isfinite(number))))
      return {};
    numbers << number;
  }
  return numbers;
}

StudyPanel::StudyPanel(Workbench* bench, SceneView* view, QWidget* parent) : QWidget(parent), Bench(bench), View(view)
{
  const QString metres = tr("Metres or auto, separated by commas");
  this->Trajectories = listEdit(QStringLiteral("studyTrajectories"), QStringLiteral("64, 256, 1024"),
                                tr("Whole numbers, separated by commas"));
  this->Deltas = listEdit(QStringLiteral("studyDeltas"), QStringLiteral("auto"), metres);
  this->Epsilons = listEdit(QStringLiteral("studyEpsilons"), QStringLiteral("0.05, 0.2, auto"), metres);
  this->Start = new QPushButton(tr("Run the study with the chosen method"));
  this->Start->setObjectName(QStringLiteral("study"));
  this->Start->setToolTip(tr("Runs every combination of the values above"));
  this->Redraw = new QPushButton(tr("Draw from here"));
  this->Redraw->setObjectName(QStringLiteral("studyRedraw"));
  this->Redraw->setToolTip(tr("Draws the pictures as the scene is seen now"));
  this->Grid = new QTableWidget;
  this->Grid->setObjectName(QStringLiteral("studyGrid"));
  this->Grid->setToolTip(
      tr("The error is the root mean square of the deviations from the truth or the reference, the "
         "bias their mean, both relative to its mean"));
  this->Grid->setIconSize({pictureSize, pictureSize});
  this->Grid->setItemDelegate(new PictureDelegate(this->Grid));
  this->Grid->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Grid->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Grid->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  this->Grid->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  this->Bar = new LegendBar(Qt::Horizontal);
  this->Bar->setObjectName(QStringLiteral("studyLegend"));
  this->About = new QLabel;
  this->About->setObjectName(QStringLiteral("studyAbout"));
  this->About->setWordWrap(true);
  auto* form = new QFormLayout;
  form->addRow(tr("Trajectories"), this->Trajectories);
  form->addRow(tr("δ, m"), this->Deltas);
  form->addRow(tr("ε, m"), this->Epsilons);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(this->Start, 1);
  buttons->addWidget(this->Redraw);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addLayout(buttons);
  layout->addWidget(this->Grid, 1);
  layout->addWidget(this->Bar);
  layout->addWidget(this->About);
  this->Soon.setSingleShot(true);
  connect(&this->Soon, &QTimer::timeout, this, &StudyPanel::drawNext);
  connect(this->Start, &QPushButton::clicked, this, &StudyPanel::start);
  connect(this->Redraw, &QPushButton::clicked, this, &StudyPanel::lookFromHere);
  connect(bench, &Workbench::studyChanged, this, &StudyPanel::showStudy);
  connect(bench, &Workbench::sceneChanged, this, &StudyPanel::showStudy);
  connect(bench, &Workbench::resultsChanged, this, &StudyPanel::refresh);
  connect(bench, &Workbench::displayChanged, this, &StudyPanel::refresh);
  connect(bench, &Workbench::runChanged, this,
          [this] { this->Start->setEnabled(this->Bench->scene() && !this->Bench->isBusy()); });
  connect(this->Grid, &QTableWidget::cellClicked, this, [this](int row, int column) {
    const int index = this->Bench->results().lastIndexOf(this->Cells.value(row * this->Grid->columnCount() + column));
    if (index >= 0)
      this->Bench->show(index);
  });
  this->showStudy();
}

void StudyPanel::start()
{
  Study study;
  study.base = this->Bench->settings();
  study.trajectories = numberList(this->Trajectories->text(), false);
  study.deltas = numberList(this->Deltas->text(), true);
  study.epsilons = numberList(this->Epsilons->text(), true);
  for (QLineEdit* edit : {this->Trajectories, this->Deltas, this->Epsilons})
    if (numberList(edit->text(), edit != this->Trajectories).isEmpty())
    {
      edit->setFocus();
      edit->selectAll();
      emit this->Bench->problem(tr("study: %1: is \"%2\", expected %3")
                                    .arg(edit->objectName().mid(5).toLower(), edit->text(), edit->toolTip().toLower()));
      return;
    }
  this->Bench->runStudy(study);
}

void StudyPanel::showStudy()
{
  const std::optional<Study>& study = this->Bench->study();
  this->Grid->clear();
  this->Grid->setRowCount(study ? study->rows() : 0);
  this->Grid->setColumnCount(study ? study->columns() : 0);
  this->Redraw->setEnabled(study.has_value());
  this->Cells.clear();
  this->Stale.clear();
  if (study)
  {
    this->Camera = this->View->camera();
    this->Cells.resize(study->rows() * study->columns());
    this->Stale.fill(false, this->Cells.size());
    this->Trajectories->setText(listText(study->trajectories));
    this->Deltas->setText(listText(study->deltas));
    this->Epsilons->setText(listText(study->epsilons));
    for (int row = 0; row < study->rows(); ++row)
      this->Grid->setVerticalHeaderItem(row, new QTableWidgetItem(study->rowName(row)));
    for (int column = 0; column < study->columns(); ++column)
      this->Grid->setHorizontalHeaderItem(column, new QTableWidgetItem(study->columnName(column)));
    this->Grid->horizontalHeader()->setDefaultSectionSize(pictureSize + 8);
    this->Grid->verticalHeader()->setDefaultSectionSize(pictureSize + 2 * this->fontMetrics().lineSpacing() + 14);
  }
  this->refresh();
}

void StudyPanel::lookFromHere()
{
  this->Camera = this->View->camera();
  this->Range = {0, 0};
  this->refresh();
}

void StudyPanel::refresh()
{
  const std::optional<Study>& study = this->Bench->study();
  this->Bar->setVisible(study.has_value());
  this->About->setVisible(study.has_value());
  if (!study)
    return;
  const QVector<ResultPtr> before = this->Cells;
  this->Cells = study->cells(this->Bench->results());
  for (ResultPtr& cell : this->Cells)
    if (cell && !cell->complete)
      cell.reset();
  const Display& display = this->Bench->display();
  if (this->Cells == before && display == this->Drawn && this->Range[1] > 0)
    return this->writeFigures();
  const auto range = rangeOf(this->Cells, display);
  const bool all = range != this->Range || display != this->Drawn;
  this->Range = range;
  this->Drawn = display;
  for (int i = 0; i < this->Cells.size(); ++i)
    this->Stale[i] = this->Cells[i] && (this->Stale[i] || all || this->Cells[i] != before.value(i));
  this->Bar->setLegend(pictureOf(nullptr, this->Cells, display).legend);
  this->writeFigures();
  this->Soon.start();
}

void StudyPanel::drawNext()
{
  const int cell = static_cast<int>(this->Stale.indexOf(true));
  if (cell < 0)
    return;
  this->Stale[cell] = false;
  const Picture picture = pictureOf(this->Cells[cell], this->Cells, this->Drawn).first;
  const QImage image = this->View->snapshot(picture, this->Drawn, this->Camera);
  const double ratio = this->devicePixelRatioF();
  QPixmap pixmap = QPixmap::fromImage(
      image.scaled(QSize(pictureSize, pictureSize) * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  pixmap.setDevicePixelRatio(ratio);
  this->itemOf(cell)->setIcon(QIcon(pixmap));
  this->Soon.start();
}

QTableWidgetItem* StudyPanel::itemOf(int cell)
{
  const int row = cell / this->Grid->columnCount(), column = cell % this->Grid->columnCount();
  if (!this->Grid->item(row, column))
    this->Grid->setItem(row, column, new QTableWidgetItem);
  return this->Grid->item(row, column);
}

void StudyPanel::writeFigures()
{
  const Reference reference = referenceOf(*this->Bench->scene(), this->Bench->results());
  const QString against = reference.describe();
  this->About->setText(against.isEmpty()
                           ? tr("Standard errors; what error and bias are measured against is not there.")
                           : tr("Error and bias over all points, against %1. Noise is in both.").arg(against));
  for (int i = 0; i < this->Cells.size(); ++i)
    if (const ResultPtr& result = this->Cells[i])
    {
      const auto deviation = deviationFrom(reference, result);
      const QString error = percent(deviation ? deviation->typical : result->quality.typical);
      QTableWidgetItem* item = this->itemOf(i);
      item->setText(
          deviation ? tr("error %1\nbias %2 · %3").arg(error, signedPercent(deviation->bias), duration(result->seconds))
                    : tr("standard error %1\n%2").arg(error, duration(result->seconds)));
      item->setToolTip(
          tr("%1\nstandard error %2, largest %3\nClick to show it in the scene")
              .arg(result->settings.describe(), percent(result->quality.typical), percent(result->quality.largest)));
    }
}
}  // namespace studio
