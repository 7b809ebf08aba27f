#include "coupling/exchange/regimes/known_columns.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "config/options/values.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/exchange/regimes/columns.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::string_view comment_column = "note";

}  // namespace

void refuse_unknown_columns(const config::Table& table, config::Problems& problems) {
    std::vector<std::string> known{std::string{comment_column}};
    for (const RegimeColumn& column : regime_columns()) {
        known.emplace_back(column.name);
    }
    static_cast<void>(table.has(comment_column));  // read by people
    for (const std::string& column : table.columns_beside(known)) {
        const std::string nearest = config::nearest_word(column, known);
        problems.add(config::ExitCode::data, {table.file(), 0, 0},
                     joined("column ", config::in_quotes(column)),
                     nearest.empty() ? "a column of a regime (coupling/exchange/regimes/README.md)"
                                     : config::in_quotes(nearest));
    }
}

}  // namespace coupling
