// SPDX-License-Identifier: BSD-3-Clause
// What has to be set before and after a QApplication is made; the tests do the same as the program.
#ifndef studio_Application_h
#define studio_Application_h

#include <QString>

namespace studio
{
void prepareApplication();  ///< before QApplication: OpenGL format, high resolution, names
void styleApplication();    ///< after: style and colours
QString demoScene();
}  // namespace studio

#endif
