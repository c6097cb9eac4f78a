// SPDX-License-Identifier: BSD-3-Clause
// Charts under the mouse: curves that are hidden, zoom, values read out; and what their axes name.
#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "charts/ChartDrawing.h"
#include "charts/ChartView.h"

using namespace studio;

class TestStudioCharts : public QObject
{
  Q_OBJECT

  static Chart chart()
  {
    Chart chart;
    chart.xLabel = "distance, m";
    chart.yLabel = "illuminance, lx";
    chart.logX = true;
    chart.series << straight("flat", 0x1b6ca8, false, {0.001, 10}, {1, 12})
                 << straight("steep", 0xd1495b, false, {0.001, 10}, {1, 900});
    return chart;
  }

  static ChartLayout layoutOf(const ChartView& view)
  {
    return layOut(chartFont(view.font()), view.rect(), view.chart());
  }

private slots:
  void curveGoesWithAClickOnItsName()
  {
    ChartView view;
    view.resize(400, 300);
    view.setChart(this->chart());
    view.show();
    const double before = layoutOf(view).y.range[1];
    auto clickName = [&] {
      QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, layoutOf(view).names[1].place.center().toPoint());
    };
    clickName();
    QVERIFY(view.chart().series[1].hidden && !view.chart().series[0].hidden);
    QVERIFY2(layoutOf(view).y.range[1] < 0.1 * before, "what is left fills the chart");
    view.setChart(this->chart());
    QVERIFY2(view.chart().series[1].hidden, "it stays hidden when there are new values");
    clickName();
    QVERIFY(!view.chart().series[1].hidden);
  }

  void wheelZoomsAboutThePointer()
  {
    ChartView view;
    view.resize(400, 300);
    view.setChart(this->chart());
    view.show();
    const ChartLayout before = layoutOf(view);
    const QPointF at = before.plot.center();
    QWheelEvent wheel(at, view.mapToGlobal(at.toPoint()), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&view, &wheel);
    const Axis x = layoutOf(view).x;
    QVERIFY(std::abs(x.value(0.5) / before.x.value(0.5) - 1) < 1e-9);
    // Two notches of 0.8 each on three decades.
    QVERIFY(std::abs(std::log10(x.range[1] / x.range[0]) - 3 * 0.64) < 1e-9);
    QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, at.toPoint());
    QCOMPARE(layoutOf(view).x.range, before.x.range);
  }

  void valuesUnderThePointerAreReadOut()
  {
    ChartView view;
    view.resize(400, 300);
    view.setChart(this->chart());
    view.show();
    const QPoint at = layoutOf(view).plot.center().toPoint();
    const QImage before = view.grab().toImage();
    auto moveTo = [&](const QPoint& place) {
      QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
      QApplication::sendEvent(&view, &move);
    };
    moveTo(at);
    const QImage during = view.grab().toImage();
    QVERIFY(during != before);
    QVERIFY2(during.pixelColor(at + QPoint(0, 40)) != before.pixelColor(at + QPoint(0, 40)) ||
                 during.pixelColor(at + QPoint(0, 41)) != before.pixelColor(at + QPoint(0, 41)),
             "a dotted line");
    moveTo({2, 2});
    QCOMPARE(view.grab().toImage(), before);
  }

  void everyDecadeIsNamed()
  {
    Chart speed = this->chart();
    speed.series = {straight("run", 0, false, {0.3, 1}, {30, 2})};
    const QVector<double> ticks = xAxis(speed).ticks(3);
    QVERIFY(ticks.contains(1) && ticks.contains(10));
  }
};

QTEST_MAIN(TestStudioCharts)
#include "TestStudioCharts.moc"
