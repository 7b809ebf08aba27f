#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/inputs/plausible/terrain/finding.hpp"
#include "coupling/inputs/plausible/terrain/height_field.hpp"

namespace coupling::plausible::terrain {

/// One rule on heights. Every rule gives the same answer for a field turned by 90 degrees or mirrored (the
/// test of this file holds all rules of the list to it), and none where too few cells are known.
struct Rule {
    std::string_view name;
    std::optional<Finding> (*judge)(const HeightField& field);
};

/// All rules, the most telling first: what is wrong in one way is conspicuous in others, too.
std::span<const Rule> all_rules();

/// Findings, and the rules that made them.
struct Verdict {
    std::string_view rule;
    Finding finding;
};

/// The rules in their order up to the first error; the warnings before it are left out then, as they follow
/// from it.
std::vector<Verdict> judge_heights(const HeightField& field);

}  // namespace coupling::plausible::terrain
