// SPDX-License-Identifier: BSD-3-Clause
// The window: view and legend in the middle, panels around it, menus.
#ifndef studio_MainWindow_h
#define studio_MainWindow_h

#include <QFileSystemWatcher>
#include <QMainWindow>
#include <functional>

#include "charts/LegendBar.h"
#include "session/Workbench.h"
#include "view/SceneView.h"

class QMenu;
class QTabWidget;

namespace studio
{
class ComparePanel;
class ImagePanel;

class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  explicit MainWindow(QWidget* parent = nullptr);

  /// Opens a scene; a broken one gives a dialog with the file, the place and the reason, and the scene before stays.
  bool openFile(const QString& path);

  /// The scene that the program is started with; the demo scene where there is none, or where it is broken.
  void openFirst(const QString& path);

  Workbench* bench() { return &this->Bench; }
  SceneView* view() const { return this->View; }

  /// The view, or the image of luminance where that is in front, with its legend.
  QImage pictureWithLegend();

  /// Offers the session that a crash has left, if there is one.
  void offerAutosave();

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void makeMenus();
  void makeFileMenu();
  void explainKeys();
  void makePanels();
  void chooseFile();
  void listRecent();
  void listCameras();
  void showScene();
  void showResult();
  void showLegend();
  bool showsImage() const;
  void updatePicking();
  void complain(const QString& message);
  bool attempt(const std::function<void()>& action);  // complains of the Problem that it throws; then false
  bool saveSessionAs();
  bool mayDropResults();
  bool offerTurning();
  void offerUnits();
  void editScene(const QJsonObject& draft);
  bool saveSceneAs();
  void reload();
  void watchFile();
  void exportPictureAs();
  void exportResultsTo();
  void exportImageAs();
  void saveQuietly(const QString& path);
  void autosave();
  void mark(int kind, const QVector<QVector<Point>>& lines);

  Workbench Bench;
  SceneView* View;
  ImagePanel* Image;
  QTabWidget* Centre;
  LegendBar* Bar;
  Legend SceneLegend;
  ComparePanel* Compare;
  std::array<QVector<QVector<Point>>, 3> Marks;  // of the probe, of the line and of the lens
  QString ShownPath;
  QFileSystemWatcher Watcher;
  QMenu *RecentMenu, *CameraMenu;
};
}  // namespace studio

#endif
