// SPDX-License-Identifier: MIT
// How is a family kept in a file? As JSON: the exact system, p*, the roots to the last digit, and a
// checksum over all before it.
//
//   {"moivre_family": 1, "kind": ..., "source": ..., "families": [...], "checksum": "<16 hex
//   digits>"}
//
// kind: "polynomials", one family; "mechanism", one for each block of its closure equations, added
// as they are met.
// Reading gives a consistent family, or refuses the file. Refused are files of another kind or a
// later version, truncated files, and files with a changed byte (FNV-1a over the text; it guards
// against accidents, not against forgery).
#pragma once

#include "moivre/expression/source.h"
#include "moivre/family/family.h"

namespace moivre {

inline constexpr int kFamilyFileVersion = 1;
inline constexpr const char* kPolynomialsKind = "polynomials";
inline constexpr const char* kMechanismKind = "mechanism";

struct FamilyFile {
  std::string kind = kPolynomialsKind;
  std::string source;  ///< name of the file that it was learned from
  std::vector<Family> families;

  friend bool operator==(const FamilyFile&, const FamilyFile&) = default;
};

/// Throws std::invalid_argument where a name cannot be written (polynomial/read.h).
std::string family_text(const FamilyFile& file);

/// Throws std::invalid_argument with the reason.
FamilyFile read_family(const Source& source);

/// Reads and writes the file at `path`. A new file is written next to it and moved there when
/// complete, so that a crash leaves the old one. Throws std::invalid_argument with the reason.
FamilyFile load_family(const std::string& path);
void save_family(const FamilyFile& file, const std::string& path);

}  // namespace moivre
