// SPDX-License-Identifier: BSD-3-Clause
// Limits how often the window shows new results of a run, so that drawing takes a small share of the time at any size
// of the window.
#ifndef studio_RedrawBudget_h
#define studio_RedrawBudget_h

#include <QElapsedTimer>
#include <QObject>

namespace studio
{
/// Measures how long the event loop of this thread has been busy since the last redraw.
class RedrawBudget : public QObject
{
  Q_OBJECT

public:
  /// `share` of the time may go into redraws, above 0 to 1.
  explicit RedrawBudget(double share, QObject* parent = nullptr);

  void redrawn();    ///< a redraw begins: what the thread does from now on is its cost
  int wait() const;  ///< ms until the next redraw; 0: now

private:
  double busy() const;  // ms since the last redraw

  double Share;
  double Busy = 0;  // ms, until the loop went to sleep the last time
  QElapsedTimer Since, Awake;
  bool Asleep = false;
};
}  // namespace studio

#endif
