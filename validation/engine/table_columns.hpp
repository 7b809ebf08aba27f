#pragma once

#include <functional>
#include <limits>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

#include "coupling/results/tables/table_of.hpp"
#include "validation/engine/tables.hpp"

namespace coupling::validation {

inline constexpr double no_entry = std::numeric_limits<double>::quiet_NaN();
inline constexpr int table_decimals = 5;
inline constexpr const char* of_quantity = "as the quantity says";
inline constexpr const char* from_case = "input, the case's folder";
inline constexpr const char* from_series = "simulated, small series";
inline constexpr const char* from_criterion = "verdict, by the criterion";

/// A row that belongs to a case, and one that belongs to a variant of it.
struct OfCase {
    const CaseResult& result;
};
struct OfVariant : OfCase {
    const VariantOutcome& variant;
};

ColumnsOf<OfCase> case_columns();
ColumnsOf<OfVariant> variant_columns();

/// "inside", "missed", or "" without criterion.
std::string_view word_of(Verdict verdict);

/// Writes a table whose rows `add_rows(rows, result)` adds for each case.
template <class Row, class AddRows>
ResultTable result_table(const TableOf<Row>& table, AddRows add_rows, bool of_variants = false) {
    return {&table, table.sentence,
            [&table, add_rows](std::ostream& out, std::span<const CaseResult> cases) {
                table.write_to(out, [&](auto& rows) {
                    for (const CaseResult& result : cases) {
                        add_rows(rows, result);
                    }
                });
            },
            of_variants};
}

/// Tables of rocks on a slope: run-out, jumps, hits on trees, factors, directions.
std::vector<ResultTable> slope_tables();

}  // namespace coupling::validation
