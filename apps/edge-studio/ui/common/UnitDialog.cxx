// SPDX-License-Identifier: BSD-3-Clause
#include "common/UnitDialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>

#include "scene/SceneDraft.h"

namespace studio
{
bool isImplausible(double size)
{
  return size < 0.3 || size > 1000;
}

UnitDialog::UnitDialog(double size, QWidget* parent) : QDialog(parent)
{
  this->setObjectName(QStringLiteral("units"));
  this->setWindowTitle(QCoreApplication::translate("studio::UnitDialog", "Unit of the model"));
  auto tr = [](const char* text) { return QCoreApplication::translate("studio::UnitDialog", text); };
  auto* about = new QLabel(tr("In metres the model is %1 m large. Which unit has the file?").arg(size, 0, 'g', 3));
  this->Unit = new QComboBox;
  this->Unit->setObjectName(QStringLiteral("unit"));
  this->Unit->addItem(tr("metres"), 1.0);
  this->Unit->addItem(tr("centimetres"), 0.01);
  this->Unit->addItem(tr("millimetres"), 0.001);
  this->Unit->addItem(tr("inches"), 0.0254);
  this->Unit->addItem(tr("feet"), 0.3048);
  this->Unit->setToolTip(tr("Unit of length of the file"));
  this->Up = new QComboBox;
  this->Up->setObjectName(QStringLiteral("up"));
  this->Up->addItem(tr("as in the file"), QString());
  this->Up->addItem(QStringLiteral("y"), QStringLiteral("y"));
  this->Up->addItem(QStringLiteral("z"), QStringLiteral("z"));
  this->Up->setToolTip(tr("Axis of the file that points upwards"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  auto* form = new QFormLayout(this);
  form->addRow(about);
  form->addRow(tr("Unit"), this->Unit);
  form->addRow(tr("Up"), this->Up);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QJsonObject UnitDialog::applied(const QJsonObject& draft) const
{
  const DraftPath surface{QStringLiteral("surfaces"), QStringLiteral("0")};
  QJsonObject scaled =
      withValue(draft, surface + DraftPath{QStringLiteral("scale")}, this->Unit->currentData().toDouble());
  if (const QString up = this->Up->currentData().toString(); !up.isEmpty())
    scaled = withValue(scaled, surface + DraftPath{QStringLiteral("up")}, up);
  return scaled;
}
}  // namespace studio
