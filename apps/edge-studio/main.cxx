// SPDX-License-Identifier: BSD-3-Clause
// edge-studio [SCENE]: without a scene, the Cornell room.
#include <QApplication>
#include <QCommandLineParser>

#include "window/Application.h"
#include "window/MainWindow.h"

namespace
{
/// Answers and ends the program where only help or the version is asked for.
void parse(QCommandLineParser& parser)
{
  parser.setApplicationDescription(
      QApplication::translate("main", "Illuminance and luminance of a scene, and what each method does at its edges"));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      QStringLiteral("scene"),
      QApplication::translate("main", "Kalos scene file (json), model (gltf, glb, obj) or mesh (ply, stl, vtp)"),
      QStringLiteral("[scene]"));
  parser.process(*QCoreApplication::instance());
}
}  // namespace

int main(int argc, char* argv[])
{
  studio::prepareApplication();
  for (int i = 1; i < argc; ++i)
    if (const QByteArray option(argv[i]);
        option == "-h" || option == "--help" || option == "-v" || option == "--version")
    {
      const QCoreApplication withoutScreen(argc, argv);
      QCommandLineParser parser;
      parse(parser);
    }
  QApplication application(argc, argv);
  studio::styleApplication();
  QCommandLineParser parser;
  parse(parser);

  studio::MainWindow window;
  window.show();
  window.openFirst(parser.positionalArguments().value(0));
  window.offerAutosave();
  return QApplication::exec();
}
