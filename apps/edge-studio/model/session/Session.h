// SPDX-License-Identifier: BSD-3-Clause
// A session as a JSON file that reopens: scene, settings, display, camera and the finished results beside it.
#ifndef studio_Session_h
#define studio_Session_h

#include "session/Workbench.h"

namespace studio
{
/// The suffix of session files.
inline const QString sessionSuffix = QStringLiteral("kalos-session.json");

/// Writes NAME.json and, in the folder NAME.results, a .vtm for each result, cancelled ones too, and a .vti of a
/// complete image. The scene's path is relative where it can be. Throws Problem, also where another file than a session
/// would be replaced. What was there before is replaced only when all has been written.
void saveSession(const Workbench& bench, const CameraPreset& camera, const QString& path);

/// Whether a JSON file is a session (and not a scene): its object has the key "kalos_edge_studio".
bool isSession(const QString& path);

/// Opens the scene of a session on the bench, with all that was saved; returns the camera. An image that was not
/// complete is computed anew, from where it was seen. Throws Problem, and then the bench stays as it was.
CameraPreset openSession(Workbench& bench, const QString& path);

/// The automatic save of the running session, left behind by a crash.
QString autosavePath();

/// The session that was closed last.
QString lastSessionPath();

/// Removes a session and its results; nothing happens where there is none.
void removeSession(const QString& path);
}  // namespace studio

#endif
