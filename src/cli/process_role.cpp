// SPDX-License-Identifier: MIT
// One role, for the process has but one.
#include "process_role.h"

namespace moivre {
namespace {

ProcessRole the_role;

}  // namespace

const ProcessRole& process_role() { return the_role; }

void set_process_role(const ProcessRole& role) { the_role = role; }

}  // namespace moivre
