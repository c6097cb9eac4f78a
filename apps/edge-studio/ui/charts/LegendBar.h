// SPDX-License-Identifier: BSD-3-Clause
// The colours of a picture with round values and the unit.
#ifndef studio_LegendBar_h
#define studio_LegendBar_h

#include <QVector>
#include <QWidget>

#include "vtkLookupTable.h"
#include "vtkSmartPointer.h"

namespace studio
{
struct Legend
{
  vtkSmartPointer<vtkLookupTable> colours;
  QString title, unit;
  QString note;                ///< below the bar
  QVector<double> isolines{};  ///< values of lines in the picture, marked and named in place of round values
};

/// An upright bar with its title above and its note below, or a lying one with its title above; this has no note.
void drawLegend(QPainter& painter, const QRectF& area, const Legend& legend, const QColor& ink,
                Qt::Orientation orientation = Qt::Vertical);

class LegendBar : public QWidget
{
public:
  explicit LegendBar(Qt::Orientation orientation = Qt::Vertical, QWidget* parent = nullptr);
  void setLegend(const Legend& legend);
  const Legend& legend() const { return this->Shown; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  Qt::Orientation Way;
  Legend Shown;
};
}  // namespace studio

#endif
