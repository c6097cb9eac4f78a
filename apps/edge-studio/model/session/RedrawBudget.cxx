// SPDX-License-Identifier: BSD-3-Clause
#include "session/RedrawBudget.h"

#include <QAbstractEventDispatcher>
#include <algorithm>
#include <cmath>

namespace studio
{
namespace
{
double milliseconds(const QElapsedTimer& clock)
{
  return 1e-6 * static_cast<double>(clock.nsecsElapsed());
}
}  // namespace

RedrawBudget::RedrawBudget(double share, QObject* parent) : QObject(parent), Share(share)
{
  this->Since.start();
  this->Awake.start();
  auto* loop = QAbstractEventDispatcher::instance();
  connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, [this] {
    this->Busy = this->busy();
    this->Asleep = true;
  });
  connect(loop, &QAbstractEventDispatcher::awake, this, [this] {
    this->Asleep = false;
    this->Awake.restart();
  });
}

double RedrawBudget::busy() const
{
  return this->Busy + (this->Asleep ? 0 : milliseconds(this->Awake));
}

void RedrawBudget::redrawn()
{
  this->Busy = 0;
  this->Since.restart();
  this->Awake.restart();
}

int RedrawBudget::wait() const
{
  return std::max(0, static_cast<int>(std::ceil(this->busy() / this->Share - milliseconds(this->Since))));
}
}  // namespace studio
