// SPDX-License-Identifier: BSD-3-Clause
// Preferences in the user's settings: recent scenes, automatic runs, the layout of the window.
#ifndef studio_Preferences_h
#define studio_Preferences_h

#include <QStringList>

namespace studio
{
QStringList recentFiles();  ///< the newest first, those that still exist
void addRecentFile(const QString& path);

bool lightsOnOpening();  ///< whether a scene is computed as soon as it is open; it is where nothing else was chosen
void setLightsOnOpening(bool value);

QByteArray windowLayout();  ///< where the docks of the window were, as QMainWindow::saveState() says it
void setWindowLayout(const QByteArray& layout);
}  // namespace studio

#endif
