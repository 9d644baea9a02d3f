// SPDX-License-Identifier: MIT
// A file of families opened before a run, and written behind it.
#include "mechanism_families.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "moivre/family/family_file.h"

namespace moivre {
namespace {

std::vector<Family> families_in(const std::string& path) {
  if (path.empty() || !std::filesystem::exists(path)) return {};
  FamilyFile file = load_family(path);
  if (file.kind == kMechanismKind) return std::move(file.families);
  throw std::invalid_argument(path +
                              ": this is the family of a polynomial file; a mechanism's are "
                              "learned by moivre family learn MECHANISM.toml");
}

/// What another process has learned meanwhile.
void add_new_ones(std::vector<Family> found, std::vector<Family>& families) {
  for (Family& family : found) {
    const bool is_known = std::any_of(families.begin(), families.end(), [&](const Family& known) {
      return known.system == family.system;
    });
    if (!is_known) families.push_back(std::move(family));
  }
}

}  // namespace

MechanismFamilies::MechanismFamilies(const std::string& path, const std::string& source,
                                     std::uint64_t seed)
    : path_(path),
      source_(source),
      is_new_(!path.empty() && !std::filesystem::exists(path)),
      book_(families_in(path), seed),
      file_(path) {}

KnownStarts* MechanismFamilies::starts() { return file_.is_wanted() ? &book_ : nullptr; }

void MechanismFamilies::keep() {
  if (!file_.is_wanted() || !(is_new_ || book_.learned() > 0)) return;
  const FolderLock lock(path_);
  FamilyFile file;
  file.kind = kMechanismKind;
  file.source = source_;
  file.families = book_.families();
  add_new_ones(families_in(path_), file.families);
  file_.write(family_text(file));
}

}  // namespace moivre
