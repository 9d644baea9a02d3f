// SPDX-License-Identifier: MIT
// How often was a pool of threads opened or set to work? Counters on the calls into oneTBB; include
// once.
//
// Every arena begins in tbb::detail::r1::initialize(task_arena_base&), every parallel loop ends in
// r1::execute_and_wait().
#pragma once

#include "counted_calls.h"

namespace moivre::test {

inline CallCounter thread_pools;

}  // namespace moivre::test

extern "C" {
void __real__ZN3tbb6detail2r110initializeERNS0_2d115task_arena_baseE(void* arena);
void __wrap__ZN3tbb6detail2r110initializeERNS0_2d115task_arena_baseE(void* arena) {
  moivre::test::thread_pools.raise();
  __real__ZN3tbb6detail2r110initializeERNS0_2d115task_arena_baseE(arena);
}
void __real__ZN3tbb6detail2r116execute_and_waitERNS0_2d14taskERNS2_18task_group_contextERNS2_12wait_contextES6_(
    void* task, void* task_context, void* wait_context, void* waiting_context);
void __wrap__ZN3tbb6detail2r116execute_and_waitERNS0_2d14taskERNS2_18task_group_contextERNS2_12wait_contextES6_(
    void* task, void* task_context, void* wait_context, void* waiting_context) {
  moivre::test::thread_pools.raise();
  __real__ZN3tbb6detail2r116execute_and_waitERNS0_2d14taskERNS2_18task_group_contextERNS2_12wait_contextES6_(
      task, task_context, wait_context, waiting_context);
}
}
