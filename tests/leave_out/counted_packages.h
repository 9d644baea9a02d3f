// SPDX-License-Identifier: MIT
// How often was SUNDIALS initialized, a CVODE memory made, a pool of threads opened? Calls into
// packages are counted.
#pragma once

#include <cvode/cvode.h>
#include <sundials/sundials_context.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "counted_calls.h"

namespace moivre::test {

using CvodeMemories = Counted<&CVodeCreate>;
using SundialsContexts = Counted<&SUNContext_Create>;

/// Every arena of oneTBB begins in `initialize`, and every parallel loop ends in the other: what
/// its users call is inline.
struct ThreadPools {
  static int calls() {
    using tbb::detail::d1::task_arena_base;
    namespace functions = tbb::detail::r1;
    return Counted<static_cast<void (*)(task_arena_base&)>(&functions::initialize)>::calls() +
           Counted<&functions::execute_and_wait>::calls();
  }
};

}  // namespace moivre::test
