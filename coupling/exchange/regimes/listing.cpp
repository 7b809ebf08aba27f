#include "coupling/exchange/regimes/listing.hpp"

#include <iomanip>
#include <string>

#include "coupling/exchange/regimes/columns.hpp"
#include "coupling/exchange/regimes/shipped.hpp"
#include "coupling/results/tables/text_layout.hpp"

namespace coupling {

void write_regime_listing(std::ostream& out) {
    out << "Shipped regimes (`bannwald info NAME` prints one, to be changed):\n";
    for (const std::string& name : shipped_regime_names()) {
        out << "  " << name << '\n';
    }
    out << "\nA regime is a CSV table, one row an intervention. Its columns, of which only `treatment` must "
           "be there:\n";
    constexpr int name_width = 24;
    const std::string indent(name_width, ' ');
    for (const RegimeColumn& column : regime_columns()) {
        std::string about{column.meaning};
        if (const std::string users = users_text(column); users != "all") {
            about.append("; for ").append(users);
        }
        if (const std::string value = default_text(column); !value.empty()) {
            about.append("; default ").append(value);
        } else if (column.rules.needed) {
            about.append("; needed");
        }
        if (!column.rules.source.empty()) {
            about.append(" (").append(column.rules.source).append(")");
        }
        const auto lines = wrapped(about, screen_columns - name_width);
        out << std::left << std::setw(name_width) << column.name << lines.front() << '\n';
        for (std::size_t i = 1; i < lines.size(); ++i) {
            out << indent << lines[i] << '\n';
        }
    }
}

}  // namespace coupling
