// SPDX-License-Identifier: MIT
// Which Moivre is compiled against? Its version as macros, for #if; moivre::version() is that of
// the library in use.
//
// The one place where the version stands: the build reads it here. Below 1.0 a new minor version
// may change the interface.
#pragma once

#define MOIVRE_VERSION_MAJOR 0
#define MOIVRE_VERSION_MINOR 1
#define MOIVRE_VERSION_PATCH 0
#define MOIVRE_VERSION_STRING "0.1.0"
/// 10000 major + 100 minor + patch, to be compared.
#define MOIVRE_VERSION \
  (MOIVRE_VERSION_MAJOR * 10000 + MOIVRE_VERSION_MINOR * 100 + MOIVRE_VERSION_PATCH)
