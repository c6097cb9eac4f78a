// SPDX-License-Identifier: BSD-3-Clause
// What tests of the model share: scenes, quick settings, the words of a Problem.
#ifndef ModelTest_h
#define ModelTest_h

#include <QTemporaryDir>

#include "Helpers.h"
#include "base/Problem.h"
#include "results/MethodSettings.h"
#include "scene/SceneDocument.h"

class ModelTest : public QObject
{
protected:
  QTemporaryDir Folder;

  studio::ScenePtr furnace()
  {
    return studio::SceneDocument::open(writeFile(this->Folder.path(), "furnace.json", furnaceRoom()));
  }
  static studio::MethodSettings quick(qint64 trajectories)
  {
    studio::MethodSettings s;
    s.trajectories = trajectories;
    return s;
  }
  template <class Action>
  static QString problemOf(const Action& action)
  {
    try
    {
      action();
    }
    catch (const studio::Problem& problem)
    {
      return problem.message();
    }
    return {};
  }
};

#endif
