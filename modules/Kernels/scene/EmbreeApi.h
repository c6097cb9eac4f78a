// SPDX-License-Identifier: BSD-3-Clause
// Embree 3 and 4 under one spelling. The only file of Kalos that includes Embree.
#ifndef kalos_scene_EmbreeApi_h
#define kalos_scene_EmbreeApi_h

#if KALOS_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace kalos::embree
{
// Traversal with a filter that sees every candidate; `context` is what the filter finds in its arguments. Packets have
// no filter.
#if KALOS_EMBREE_VERSION >= 4
using QueryContext = RTCRayQueryContext;
constexpr auto filterFlag = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

template <class Arguments>
void setFilter(Arguments& arguments, QueryContext& context, RTCFilterFunctionN filter)
{
  rtcInitRayQueryContext(&context);
  arguments.context = &context;
  arguments.filter = filter;
  arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
}

inline void traceFirst(RTCScene scene, QueryContext& context, RTCFilterFunctionN filter, RTCRayHit& query)
{
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  setFilter(arguments, context, filter);
  rtcIntersect1(scene, &query, &arguments);
}

inline void traceAny(RTCScene scene, QueryContext& context, RTCFilterFunctionN filter, RTCRay& ray)
{
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  setFilter(arguments, context, filter);
  rtcOccluded1(scene, &ray, &arguments);
}

inline void traceFirst(RTCScene scene, const int* valid, RTCRayHit16& query)
{
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  rtcIntersect16(valid, scene, &query, &arguments);
}

inline void traceAny(RTCScene scene, const int* valid, RTCRay16& rays)
{
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  rtcOccluded16(valid, scene, &rays, &arguments);
}
#else
using QueryContext = RTCIntersectContext;
constexpr auto filterFlag = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

inline void traceFirst(RTCScene scene, QueryContext& context, RTCFilterFunctionN filter, RTCRayHit& query)
{
  rtcInitIntersectContext(&context);
  context.filter = filter;
  rtcIntersect1(scene, &context, &query);
}

inline void traceAny(RTCScene scene, QueryContext& context, RTCFilterFunctionN filter, RTCRay& ray)
{
  rtcInitIntersectContext(&context);
  context.filter = filter;
  rtcOccluded1(scene, &context, &ray);
}

inline void traceFirst(RTCScene scene, const int* valid, RTCRayHit16& query)
{
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect16(valid, scene, &context, &query);
}

inline void traceAny(RTCScene scene, const int* valid, RTCRay16& rays)
{
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(valid, scene, &context, &rays);
}
#endif
}  // namespace kalos::embree

#endif
