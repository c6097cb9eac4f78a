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

void drawLegend(QPainter& painter, const QRectF& area, const Legend& legend, const QColor& ink);

class LegendBar : public QWidget
{
public:
  explicit LegendBar(QWidget* parent = nullptr);
  void setLegend(const Legend& legend);
  const Legend& legend() const { return this->Shown; }
  QSize sizeHint() const override { return {92, 300}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  Legend Shown;
};
}  // namespace studio

#endif
