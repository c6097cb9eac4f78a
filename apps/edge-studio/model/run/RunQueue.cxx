// SPDX-License-Identifier: BSD-3-Clause
#include "run/RunQueue.h"

namespace studio
{
void RunQueue::start(const ScenePtr& scene, const QVector<Job>& jobs)
{
  this->forget();
  this->Scene = scene;
  this->Jobs = jobs;
  this->Results = QVector<ResultPtr>(jobs.size());
  this->next();
}

void RunQueue::forget()
{
  this->Current.reset();
  this->Jobs.clear();
  this->Results.clear();
  this->At = 0;
}

void RunQueue::cancel()
{
  if (this->Current)
    this->Current->cancel();
}

void RunQueue::next()
{
  if (this->At == this->Jobs.size())
  {
    this->Current.reset();
    emit this->ended();
    return;
  }
  const Job& job = this->Jobs[this->At];
  this->Current = std::make_unique<Run>(this->Scene, job.receivers, job.settings);
  connect(this->Current.get(), &Run::refined, this, [this] {
    this->Results[this->At] = this->Current->result();
    emit this->refined(this->At);
  });
  // The handler replaces the run, so it must not be called while the run is still emitting.
  connect(
      this->Current.get(), &Run::ended, this,
      [this, run = this->Current.get()] {
        if (run != this->Current.get())
          return;  // another one was started meanwhile
        const Run::State state = this->Current->state();
        const QString problem = this->Current->problem();
        if (state == Run::State::Finished)
        {
          ++this->At;
          return this->next();
        }
        this->Current.reset();
        if (state == Run::State::Failed)
          emit this->failed(problem);
        emit this->ended();
      },
      Qt::QueuedConnection);
}
}  // namespace studio
