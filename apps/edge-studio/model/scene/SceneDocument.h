// SPDX-License-Identifier: BSD-3-Clause
// A scene as Edge Studio shows it: the content of the file, its singular edges, and surfaces divided into display
// cells.
#ifndef studio_SceneDocument_h
#define studio_SceneDocument_h

#include <QHash>
#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <QVector>
#include <memory>
#include <optional>

#include "scene/CameraPreset.h"
#include "scene/FineShadows.h"
#include "scene/PaintedSurface.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace studio
{
/// Once opened, it never changes: views and runs share it.
class SceneDocument
{
public:
  /// A Kalos scene file or a model (gltf, glb, obj with materials), or a bare mesh (obj, ply, stl, vtp), which is then
  /// lit as a white furnace: reflectance 0.5 and exitance 100 lm/m2 everywhere, so that the illuminance is 200 lx at
  /// every point of a closed mesh with its fronts inside. `turned` exchanges the sides of a bare mesh. Throws Problem.
  static std::shared_ptr<const SceneDocument> open(const QString& path, bool turned = false);

  /// A scene file that is being edited, see SceneDraft.h; messages and path() are of the file that it was read from.
  static std::shared_ptr<const SceneDocument> fromDraft(const QJsonObject& draft, const QString& path,
                                                        bool turned = false);

  const QString& path() const { return this->Path; }
  QString name() const;
  vtkPolyData* surfaces() const { return this->Surfaces; }
  vtkPolyData* luminaires() const { return this->Luminaires; }
  vtkPolyData* edges() const { return this->Edges; }  ///< output 0 of vtkKalosSingularEdges
  const QVector<CameraPreset>& cameras() const { return this->Cameras; }
  double size() const;  ///< diagonal of the bounding box, m

  /// Names of the receiver sets: paintedName() first, then those of the file.
  QStringList sets() const;
  static QString paintedName() { return QStringLiteral("surfaces"); }
  /// The cells of the first set. Large scenes have more triangles than receivers.
  const PaintedSurface& painted() const { return this->Painted; }
  /// Finer cells of a set for its picture; null where there are none.
  std::shared_ptr<const FineShadows> fineShadows(const QString& set) const { return this->Fine.value(set); }
  /// Sets to compute when a user has not chosen: all but the file's own cuts of surfaces, which the first set covers.
  QStringList usualSets() const;
  /// These sets as blocks, for vtkKalosIlluminance.
  vtkSmartPointer<vtkMultiBlockDataSet> receivers(const QStringList& names) const;

  /// Illuminance at every surface point where it is known, see Furnace.h.
  std::optional<double> furnaceIlluminance() const { return this->Furnace; }
  /// Whether some surface has gloss or a mirror, so that its luminance depends on where one looks from.
  bool hasGloss() const;
  bool isBareMesh() const { return this->BareMesh; }
  bool isTurned() const { return this->Turned; }
  /// A closed bare mesh with its fronts outside: it lights the space around it, and its inside stays dark.
  bool facesOutward() const { return this->Outward; }

private:
  void read(const QString& sceneFile);
  void complete();
  void refineShadows();

  QString Path;
  bool BareMesh = false, Turned = false, Outward = false;
  vtkSmartPointer<vtkPolyData> Surfaces, Luminaires, Edges;
  PaintedSurface Painted;
  vtkSmartPointer<vtkMultiBlockDataSet> FileReceivers;
  QVector<CameraPreset> Cameras;
  QHash<QString, std::shared_ptr<const FineShadows>> Fine;
  std::optional<double> Furnace;
};

using ScenePtr = std::shared_ptr<const SceneDocument>;
}  // namespace studio

#endif
