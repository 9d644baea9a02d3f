# SPDX-License-Identifier: MIT
# The warnings that both compilers must be silent at; a target takes them by linking moivre_warnings privately.

add_library(moivre_warnings INTERFACE)
target_compile_options(moivre_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wswitch-enum)
if(MOIVRE_WARNINGS_AS_ERRORS)
  target_compile_options(moivre_warnings INTERFACE -Werror)
endif()
