// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with input, in one line: `FILE: WHERE: what is wrong and what is expected`.
#ifndef studio_Problem_h
#define studio_Problem_h

#include <QString>
#include <stdexcept>

namespace studio
{
class Problem : public std::runtime_error
{
public:
  explicit Problem(const QString& message) : std::runtime_error(message.toStdString()) {}
  QString message() const { return QString::fromUtf8(this->what()); }
};
}  // namespace studio

#endif
