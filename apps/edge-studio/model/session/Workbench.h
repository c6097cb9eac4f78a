// SPDX-License-Identifier: BSD-3-Clause
// What the studio has on its bench: a scene, settings that can be undone, a run, and the results so far.
#ifndef studio_Workbench_h
#define studio_Workbench_h

#include <QObject>
#include <QPointF>
#include <memory>

#include "base/UndoHistory.h"
#include "results/Display.h"
#include "run/CameraImage.h"
#include "run/Run.h"
#include "study/Study.h"

namespace studio
{
class Workbench : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  /// Throws Problem; then the scene before stays. Results of the scene before are dropped.
  void open(const QString& path);
  const ScenePtr& scene() const { return this->Scene; }

  const MethodSettings& settings() const { return this->History.current(); }
  void setSettings(const MethodSettings& settings);
  bool canUndo() const { return this->History.canUndo(); }
  bool canRedo() const { return this->History.canRedo(); }

  const studio::Display& display() const { return this->Shown; }
  void setDisplay(const studio::Display& display);

  /// Receiver sets that the next run computes.
  const QStringList& chosenSets() const { return this->Chosen; }
  void setChosenSets(const QStringList& names);

  Run* activeRun() const { return this->Current.get(); }  ///< the last one started, also when it has ended; null before
  bool isRunning() const { return this->Current && this->Current->active(); }

  /// Every run that left something, in the order of their starts; the last grows while it runs.
  const QVector<ResultPtr>& results() const { return this->Results; }
  int shownIndex() const { return this->ShownIndex; }
  ResultPtr shown() const { return this->Results.value(this->ShownIndex); }
  void show(int index);
  void addResult(const ResultPtr& result);

  /// Runs these settings one after the other; cancel() stops the whole series.
  void runSeries(const QVector<MethodSettings>& series);
  int seriesLeft() const { return static_cast<int>(this->Series.size()); }  ///< after the run under way

  /// How the error of each result fell while it ran: (s, root mean square of the relative standard error).
  const QVector<QVector<QPointF>>& tracks() const { return this->Tracks; }

  /// Runs a study, cell by cell.
  void runStudy(const Study& study);
  const std::optional<Study>& study() const { return this->Studied; }
  void setStudy(const std::optional<Study>& study);  ///< without running it

  /// What the picture of the shown result shares one scale with: the cells of its study, or nothing but itself.
  QVector<ResultPtr> onOneScale() const;

  /// The luminance that a camera sees.
  CameraImage& image() { return this->Seen; }
  const CameraImage& image() const { return this->Seen; }

public slots:
  void undo();
  void redo();
  void run();  ///< stops what is under way
  void cancel();

signals:
  void sceneChanged();
  void settingsChanged();
  void displayChanged();
  void resultsChanged();  ///< a result is new, newer, gone, or another one is shown
  void studyChanged();
  void runChanged();  ///< it began, rests, goes on, ended
  void runBegan();
  void runEnded();
  void problem(const QString& message);

private:
  void runNext();
  void takeResult();

  ScenePtr Scene;
  UndoHistory<MethodSettings> History;
  studio::Display Shown;
  QStringList Chosen;
  std::unique_ptr<Run> Current;
  bool CurrentHasResult = false;   // the last of Results is Current's
  QVector<MethodSettings> Series;  // still to be run
  std::optional<Study> Studied;
  CameraImage Seen;
  QVector<ResultPtr> Results;
  QVector<QVector<QPointF>> Tracks;
  int ShownIndex = -1;
};
}  // namespace studio

#endif
