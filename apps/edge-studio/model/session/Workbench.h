// SPDX-License-Identifier: BSD-3-Clause
// The state of the application: a scene, settings with undo, the current run, and all results.
#ifndef studio_Workbench_h
#define studio_Workbench_h

#include <QHash>
#include <QObject>
#include <QPointF>
#include <QTimer>
#include <memory>

#include "base/UndoHistory.h"
#include "results/Display.h"
#include "results/Statistics.h"
#include "run/CameraImage.h"
#include "run/Run.h"
#include "session/RedrawBudget.h"
#include "study/Study.h"

namespace studio
{
class Workbench : public QObject
{
  Q_OBJECT

public:
  explicit Workbench(QObject* parent = nullptr);

  /// Throws Problem; then the scene before stays. Results of the scene before are dropped. `turned` as in
  /// SceneDocument::open().
  void open(const QString& path, bool turned = false);
  const ScenePtr& scene() const { return this->Scene; }

  /// The scene file as it is edited, see SceneDraft.h. A changed one is opened, and drops the results; throws Problem,
  /// then all stays.
  const QJsonObject& draft() const { return this->History.current().draft; }
  void edit(const QJsonObject& draft);
  bool isEdited() const { return this->draft() != this->SavedDraft; }
  /// Writes the draft as a scene file. Throws Problem.
  void saveScene(const QString& path);

  const MethodSettings& settings() const { return this->History.current().settings; }
  void setSettings(const MethodSettings& settings);
  bool canUndo() const { return this->History.canUndo(); }
  bool canRedo() const { return this->History.canRedo(); }

  const studio::Display& display() const { return this->History.current().display; }
  void setDisplay(const studio::Display& display);

  /// Receiver sets that the next run computes.
  const QStringList& chosenSets() const { return this->ChosenSets; }
  void setChosenSets(const QStringList& names);

  Run* activeRun() const { return this->Current.get(); }  ///< the last one started, also when it has ended; null before
  bool isRunning() const { return this->Current && this->Current->active(); }
  /// Whether a run that a user asked for is under way; others make room for the next one.
  bool isBusy() const { return this->isRunning() && this->Asked; }

  /// The result of every run that had one, in the order of their starts; the last is refined during its run.
  const QVector<ResultPtr>& results() const { return this->Results; }
  int shownIndex() const { return this->ShownIndex; }
  ResultPtr shown() const { return this->Results.value(this->ShownIndex); }
  void show(int index);
  void addResult(const ResultPtr& result);
  void rename(int index, const QString& name);
  /// Whether a result is there and not being refined.
  bool canRemove(int index) const;
  void remove(int index);

  /// Runs these settings one after the other; cancel() stops the whole series.
  void runSeries(const QVector<MethodSettings>& series);
  /// Runs the fast method for a second, then the chosen settings. These results do not count as unsaved().
  void runUnasked();

  /// Whether there are results of runs that were asked for since the last markSaved(), or such a run is under way; or
  /// the scene is edited and not saved.
  bool unsaved() const { return this->hasUnsavedResults() || this->isEdited(); }
  bool hasUnsavedResults() const { return this->Unsaved || this->isBusy(); }
  void markSaved() { this->Unsaved = false; }
  int seriesLeft() const { return static_cast<int>(this->Series.size()); }  ///< after the run under way

  /// ms until the window should show more of a run.
  int redrawWait() const { return this->Budget.wait(); }

  /// How the error of each result fell while it ran: (s, root mean square of the relative standard error).
  const QVector<QVector<QPointF>>& tracks() const { return this->Tracks; }

  /// Runs a study, cell by cell.
  void runStudy(const Study& study);
  const std::optional<Study>& study() const { return this->CurrentStudy; }
  void setStudy(const std::optional<Study>& study);  ///< without running it

  /// What a task requires of a set of points; nothing by default.
  Requirement requirement(const QString& set) const { return this->Required.value(set); }
  const QHash<QString, Requirement>& requirements() const { return this->Required; }
  void require(const QString& set, const Requirement& requirement);

  /// The results that share one scale with the shown one: the cells of its study, else itself only.
  QVector<ResultPtr> onOneScale() const;

  /// The luminance that a camera sees.
  CameraImage& image() { return this->Image; }
  const CameraImage& image() const { return this->Image; }

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
  void requirementsChanged();
  void runChanged();  ///< it began, paused, continued or ended
  void runBegan();
  void runEnded();
  void problem(const QString& message);

private:
  /// What undo brings back.
  struct State
  {
    MethodSettings settings;
    studio::Display display;
    QJsonObject draft;

    bool operator==(const State& other) const
    {
      return this->settings == other.settings && this->display == other.display && this->draft == other.draft;
    }
  };
  void restore(const State& before, bool redone);
  void takeScene(const ScenePtr& scene);
  void start(const QVector<MethodSettings>& series, bool asked);
  void runNext();
  void endRun();
  void takeResult();
  void showResult();
  bool showsAll() const;

  ScenePtr Scene;
  UndoHistory<State> History;
  QJsonObject SavedDraft;
  QStringList ChosenSets;
  std::unique_ptr<Run> Current;
  bool CurrentHasResult = false;   // the last of Results is Current's
  QVector<MethodSettings> Series;  // still to be run
  std::optional<Study> CurrentStudy;
  QHash<QString, Requirement> Required;
  CameraImage Image;
  QVector<ResultPtr> Results;
  QVector<QVector<QPointF>> Tracks;
  int ShownIndex = -1;
  bool Follows = true;  // what is shown changes to the newest result
  bool Asked = false;   // for the run under way
  bool Unsaved = false;
  RedrawBudget Budget{0.08};
  QTimer Later;  // to show what is new
};
}  // namespace studio

#endif
