// SPDX-License-Identifier: MIT
// How often was SUNDIALS initialized, and a CVODE memory made? Counters on the calls; include once.
#pragma once

#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>

#include "counted_calls.h"

namespace moivre::test {

inline CallCounter sundials_contexts;
inline CallCounter cvode_memories;

}  // namespace moivre::test

#if SUNDIALS_VERSION_MAJOR < 7
using SunCommunicator = void*;
#else
using SunCommunicator = SUNComm;
#endif

extern "C" {
int __real_SUNContext_Create(SunCommunicator communicator, SUNContext* context);
int __wrap_SUNContext_Create(SunCommunicator communicator, SUNContext* context) {
  moivre::test::sundials_contexts.raise();
  return __real_SUNContext_Create(communicator, context);
}
void* __real_CVodeCreate(int method, SUNContext context);
void* __wrap_CVodeCreate(int method, SUNContext context) {
  moivre::test::cvode_memories.raise();
  return __real_CVodeCreate(method, context);
}
}
