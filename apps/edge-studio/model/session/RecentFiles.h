// SPDX-License-Identifier: BSD-3-Clause
// The scenes that were opened last, the newest first, kept in the user's settings.
#ifndef studio_RecentFiles_h
#define studio_RecentFiles_h

#include <QStringList>

namespace studio
{
QStringList recentFiles();  ///< those that still exist
void addRecentFile(const QString& path);
}  // namespace studio

#endif
