#include "validation/engine/paper_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "config/text/joined.hpp"
#include "validation/engine/screen.hpp"

namespace coupling::validation {
namespace {

constexpr std::array variant_names{"initial", "improved_rebound", "strict", "strict_scatter", "default"};

const VariantOutcome* outcome_named(const CaseResult& result, const std::string& name) {
    const auto found = std::find_if(result.variants.begin(), result.variants.end(),
                                    [&](const VariantOutcome& variant) { return variant.variant == name; });
    return found == result.variants.end() ? nullptr : &*found;
}

std::string value_of(const VariantOutcome& variant, const std::string& quantity, const std::string& unit) {
    const auto found = variant.values.find(quantity);
    return found == variant.values.end() ? "" : figure_text(found->second.value, unit);
}

/// Mean length of the jumps that end in the upper or the lower half of the slope.
std::string mean_jump(const VariantOutcome& variant, bool upper) {
    double sum_m = 0.0;
    double jumps = 0.0;
    for (const SegmentJumps& segment : variant.jumps) {
        if (segment.upper == upper) {
            sum_m += segment.mean_m * static_cast<double>(segment.jumps);
            jumps += static_cast<double>(segment.jumps);
        }
    }
    return jumps > 0.0 ? figure_text(sum_m / jumps, "m") : "-";
}

}  // namespace

PaperVariants paper_variants(const CaseResult& result) {
    std::vector<const VariantOutcome*> variants;
    for (const char* name : variant_names) {
        if (const VariantOutcome* variant = outcome_named(result, name)) {
            variants.push_back(variant);
        }
    }
    PaperVariants table;
    if (outcome_named(result, "initial") == nullptr || outcome_named(result, "improved_rebound") == nullptr) {
        return table;
    }
    table.head = {"variants of the paper's Figs. 3 and 4", "unit", "observed", "published"};
    for (const VariantOutcome* variant : variants) {
        std::string name = variant->variant;
        std::replace(name.begin(), name.end(), '_', ' ');
        table.head.push_back(std::move(name));
    }
    const auto add = [&](std::vector<std::string> cells, const auto& value) {
        for (const VariantOutcome* variant : variants) {
            cells.push_back(value(*variant));
        }
        table.rows.push_back(std::move(cells));
    };
    for (const VerdictRow& row : result.rows) {
        const auto known = [&](const std::optional<double>& number) {
            return number ? figure_text(*number, row.unit) : std::string{};
        };
        add({row.label, row.unit, known(row.observed), known(row.published)},
            [&](const VariantOutcome& variant) { return value_of(variant, row.quantity, row.unit); });
    }
    add({"mean length of jumps, upper half of the slope", "m", "", ""},
        [](const VariantOutcome& variant) { return mean_jump(variant, true); });
    add({"mean length of jumps, lower half", "m", "", ""},
        [](const VariantOutcome& variant) { return mean_jump(variant, false); });
    return table;
}

void take_scatter_values(CaseResult& result) {
    const VariantOutcome* scatter = outcome_named(result, "strict_scatter");
    if (scatter == nullptr) {
        return;
    }
    for (VerdictRow& row : result.rows) {
        if (const auto found = scatter->values.find(row.quantity); found != scatter->values.end()) {
            row.scatter_value = found->second;
        }
    }
}

}  // namespace coupling::validation
