// SPDX-License-Identifier: BSD-3-Clause
// edge-studio [SCENE]: without a scene, the Cornell room.
#include <QApplication>
#include <QCommandLineParser>

#include "window/Application.h"
#include "window/MainWindow.h"

int main(int argc, char* argv[])
{
  studio::prepareApplication();
  QApplication application(argc, argv);
  studio::dressApplication();

  QCommandLineParser parser;
  parser.setApplicationDescription(
      QApplication::translate("main", "Illuminance and luminance of a scene, and what each method does at its edges"));
  parser.addHelpOption();
  parser.addPositionalArgument(
      QStringLiteral("scene"),
      QApplication::translate("main", "Kalos scene file (json), model (gltf, glb, obj) or mesh (ply, stl, vtp)"),
      QStringLiteral("[scene]"));
  parser.process(application);

  studio::MainWindow window;
  window.show();
  window.openFirst(parser.positionalArguments().value(0));
  window.offerAutosave();
  return QApplication::exec();
}
