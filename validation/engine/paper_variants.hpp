#pragma once

#include <string>
#include <vector>

#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// The variants of the model that Rammer et al. (2010) compare in their Figs. 3 and 4, side by side with what
/// was observed and published: head and rows of a table. Both empty for cases without these variants.
///
/// initial: constant restitution and jump angle; improved_rebound: damped restitution and Eq. 9; strict: with
/// stopping too, the paper's last. Beside strict stands strict_scatter, then default.
struct PaperVariants {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};
PaperVariants paper_variants(const CaseResult& result);

/// Enters what the variant strict_scatter gives into the rows, where the case has it.
void take_scatter_values(CaseResult& result);

}  // namespace coupling::validation
