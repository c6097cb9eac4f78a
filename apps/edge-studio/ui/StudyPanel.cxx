// SPDX-License-Identifier: BSD-3-Clause
#include "StudyPanel.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <cmath>

#include "Comparison.h"
#include "Wording.h"
#include "vtkKalosEstimatorAlgorithm.h"

namespace studio
{
namespace
{
constexpr int pictureSize = 150;

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
  this->Grid = new QTableWidget;
  this->Grid->setObjectName(QStringLiteral("studyGrid"));
  this->Grid->setIconSize({pictureSize, pictureSize});
  this->Grid->setItemDelegate(new PictureDelegate(this->Grid));
  this->Grid->setEditTriggers(QAbstractItemView::NoEditTriggers);
  auto* form = new QFormLayout;
  form->addRow(tr("Trajectories"), this->Trajectories);
  form->addRow(tr("δ, m"), this->Deltas);
  form->addRow(tr("ε, m"), this->Epsilons);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(this->Start);
  layout->addWidget(this->Grid, 1);
  connect(this->Start, &QPushButton::clicked, this, &StudyPanel::start);
  connect(view, &SceneView::painted, this, &StudyPanel::takePicture);
  connect(bench, &Workbench::runChanged, this,
          [this] { this->Start->setEnabled(this->Bench->scene() && !this->Bench->isRunning()); });
  connect(bench, &Workbench::sceneChanged, this, [this] {
    this->First = -1;
    this->Grid->clear();
    this->Grid->setRowCount(0);
    this->Grid->setColumnCount(0);
  });
  connect(this->Grid, &QTableWidget::cellClicked, this, [this](int row, int column) {
    const int index = this->First + row * this->Columns + column;
    if (this->First >= 0 && index < this->Bench->results().size())
      this->Bench->show(index);
  });
}

void StudyPanel::start()
{
  const QVector<double> trajectories = numberList(this->Trajectories->text(), false),
                        deltas = numberList(this->Deltas->text(), true),
                        epsilons = numberList(this->Epsilons->text(), true);
  for (QLineEdit* edit : {this->Trajectories, this->Deltas, this->Epsilons})
    if (numberList(edit->text(), edit != this->Trajectories).isEmpty())
    {
      edit->setFocus();
      edit->selectAll();
      emit this->Bench->problem(tr("study: %1: is \"%2\", expected %3")
                                    .arg(edit->objectName().mid(5).toLower(), edit->text(), edit->toolTip().toLower()));
      return;
    }
  QStringList across, down;
  QVector<MethodSettings> series;
  for (double n : trajectories)
    for (double delta : deltas)
      for (double epsilon : epsilons)
      {
        MethodSettings settings = this->Bench->settings();
        settings.goal = Goal::Trajectories;
        settings.trajectories = std::llround(n);
        settings.delta = delta;
        settings.epsilon = epsilon;
        series << settings;
      }
  for (double n : trajectories)
    down << tr("N = %1").arg(n);
  for (double delta : deltas)
    for (double epsilon : epsilons)
      across << tr("δ %1\nε %2").arg(lengthText(delta), lengthText(epsilon));
  this->Columns = static_cast<int>(across.size());
  this->Count = static_cast<int>(series.size());
  this->First = static_cast<int>(this->Bench->results().size());
  this->Grid->clear();
  this->Grid->setRowCount(static_cast<int>(down.size()));
  this->Grid->setColumnCount(this->Columns);
  this->Grid->setVerticalHeaderLabels(down);
  this->Grid->setHorizontalHeaderLabels(across);
  this->Grid->horizontalHeader()->setDefaultSectionSize(pictureSize + 8);
  this->Grid->verticalHeader()->setDefaultSectionSize(pictureSize + 48);
  if (this->First > 0)
    this->Bench->show(this->First - 1);  // the view follows the newest result
  this->Bench->runSeries(series);
}

QString StudyPanel::figures(const Result& result) const
{
  QString text = tr("error %1 · %2").arg(percent(result.quality.typical), duration(result.seconds));
  std::optional<Deviation> deviation;
  if (const auto truth = this->Bench->scene()->furnaceIlluminance())
    deviation = deviationFrom(*truth, result);
  else
  {
    // The best that is there of the method without bias.
    ResultPtr reference;
    for (const ResultPtr& other : this->Bench->results())
      if (other && other->complete && other->settings.method == vtkKalosEstimatorAlgorithm::COMPENSATED &&
          (!reference || other->trajectories > reference->trajectories))
        reference = other;
    if (reference && reference.get() != &result)
      deviation = deviationFrom(*reference, result);
  }
  if (deviation)
    text += QLatin1Char('\n') + tr("mean %1%2 %")
                                    .arg(deviation->bias < 0 ? QStringLiteral("−") : QStringLiteral("+"))
                                    .arg(100 * std::abs(deviation->bias), 0, 'g', 2);
  return text;
}

void StudyPanel::takePicture()
{
  const int cell = this->Bench->shownIndex() - this->First;
  const ResultPtr result = this->Bench->shown();
  if (this->First < 0 || cell < 0 || cell >= this->Count || !result || !result->complete)
    return;
  const int row = cell / this->Columns, column = cell % this->Columns;
  if (this->Grid->item(row, column))
    return;  // its picture is taken
  const QImage picture =
      this->View->picture().scaled(2 * pictureSize, 2 * pictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  this->Grid->setItem(row, column, new QTableWidgetItem(QIcon(QPixmap::fromImage(picture)), this->figures(*result)));
}
}  // namespace studio
