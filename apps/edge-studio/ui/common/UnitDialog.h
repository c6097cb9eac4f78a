// SPDX-License-Identifier: BSD-3-Clause
// Asks for the unit and the upward axis of a model whose size is implausible in metres.
#ifndef studio_UnitDialog_h
#define studio_UnitDialog_h

#include <QComboBox>
#include <QDialog>
#include <QJsonObject>

namespace studio
{
/// Whether a room or a building is hardly so large, m.
bool isImplausible(double size);

class UnitDialog : public QDialog
{
public:
  /// `size` in metres, as the file is read now.
  explicit UnitDialog(double size, QWidget* parent = nullptr);

  /// With the scale and the axis that were chosen, in the first surface.
  QJsonObject applied(const QJsonObject& draft) const;

private:
  QComboBox *Unit, *Up;
};
}  // namespace studio

#endif
