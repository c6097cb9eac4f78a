// SPDX-License-Identifier: BSD-3-Clause
// What was modelled and why, and what a user is warned of: of the files that were read and of a result.
#ifndef studio_AuditLines_h
#define studio_AuditLines_h

#include "results/Result.h"
#include "scene/SceneDocument.h"

namespace studio
{
struct AuditLine
{
  QString subject, choice, reason;
  bool warning = false;
};

/// Warnings first. `result` may be null.
QVector<AuditLine> auditLines(const SceneDocument& scene, const Result* result);
}  // namespace studio

#endif
