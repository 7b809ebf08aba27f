#include "coupling/results/vectors/layer_columns.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::vectors {

std::string unit_of(const geopackage::Column& column) {
    const std::string unit =
        column.unit.empty() ? unit_in({column.name, {}, {}, {}, column.type}) : column.unit;
    return unit == "-" || unit == "text" ? std::string{} : unit;
}

std::string with_unit(const std::string& field, const geopackage::Column& column) {
    const std::string unit = unit_of(column);
    return field.empty() || unit.empty() ? field : config::joined(field, " ", unit);
}

std::string name_of(const geopackage::Plan& plan, const std::vector<std::string>& fields) {
    const auto named = std::find_if(plan.columns.begin(), plan.columns.end(),
                                    [](const geopackage::Column& column) { return column.name == "name"; });
    const auto at = static_cast<std::size_t>(named - plan.columns.begin());
    if (named != plan.columns.end() && !fields[at].empty()) {
        return fields[at];
    }
    return fields.empty() ? std::string{} : fields.front();
}

Tags tags_of(std::string_view name, const report::Attributes& attributes) {
    const std::string whole = report::element(name, attributes, "\n");
    const std::size_t after_begin = whole.find('\n') + 1;
    return {whole.substr(0, after_begin), config::joined(whole.substr(after_begin), "\n")};
}

}  // namespace coupling::vectors
