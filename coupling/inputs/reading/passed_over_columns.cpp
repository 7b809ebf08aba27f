#include "coupling/inputs/reading/passed_over_columns.hpp"

#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/tables/meant_columns.hpp"

namespace coupling {

void warn_of_columns(const config::Table& table, const std::vector<std::string>& known, Reading& reading) {
    for (const std::string& column : table.columns_beside(known)) {
        const std::string meant = meant_column(column, known);
        // A column in another unit is an error, which comes when all has been read.
        if (!meant.empty() && !table.has(meant) &&
            !config::is_other_unit(config::form_of(column), config::form_of(meant))) {
            reading.warn({table.file()}, "column " + config::in_quotes(column) + ", which is passed over",
                         meant + ", if that is what is meant");
            table.count_as_named(column);
        }
    }
}

}  // namespace coupling
