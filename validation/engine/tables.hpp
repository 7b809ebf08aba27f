#pragma once

#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/results/tables/table_layout.hpp"
#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// A CSV table of validated cases. What is not known or not finite is an empty field.
struct ResultTable {
    const TableLayout* layout;
    std::string sentence;  ///< what it holds
    std::function<void(std::ostream&, std::span<const CaseResult>)> write;
    bool of_variants = false;  ///< empty for cases with one set of settings, such as those of the forest
};

/// verdicts.csv, figures.csv and all others, in the order in which they are listed.
const std::vector<ResultTable>& result_tables();

/// Writes one of them by its file name.
void write_table(std::ostream& out, std::string_view file, std::span<const CaseResult> cases);

}  // namespace coupling::validation
