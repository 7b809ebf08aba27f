#include "coupling/program/actions/info_tables.hpp"

#include <array>
#include <iomanip>
#include <vector>

#include "config/errors/input_error.hpp"
#include "coupling/assessments/calibrate/outcome/calibration.hpp"
#include "coupling/assessments/collapse/collapse_results.hpp"
#include "coupling/assessments/compare/runs/side_by_side.hpp"
#include "coupling/assessments/decades/decade_layouts.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/models/tables.hpp"
#include "coupling/assessments/nets/net_place.hpp"
#include "coupling/assessments/profile/profile_results.hpp"
#include "coupling/assessments/today/tables.hpp"
#include "coupling/assessments/vary/write_table.hpp"
#include "coupling/results/tables/data_dictionary.hpp"

namespace coupling {
namespace {

struct Kind {
    const char* name;
    const std::vector<TableLayout>& (*layouts)();
};

constexpr std::array kinds{Kind{"an assessment of today", static_layouts},
                           Kind{"a run over years", decades::decade_layouts},
                           Kind{"a run along a profile", profile::profile_layouts},
                           Kind{"a hazard map", hazard::hazard_layouts},
                           Kind{"a hazard map with risk.assess", hazard::risk::risk_layouts},
                           Kind{"every run", dictionary_layouts},
                           Kind{"`bannwald net` (nets.csv and others as of today)", net_command_layouts},
                           Kind{"a rock mass that breaks up", collapse::collapse_layouts},
                           Kind{"a comparison of runs", compare::compare_layouts},
                           Kind{"a run under several motion models", models::models_layouts},
                           Kind{"a study (`bannwald vary`)", vary::vary_layouts},
                           Kind{"a calibration (posterior.csv has a column for each parameter, too)",
                                calibrate::common_calibration_layouts}};

void write_columns(const TableLayout& layout, const char* kind, std::ostream& out) {
    out << layout.file << " of " << kind << ": a row is " << layout.row << '\n';
    for (const Column& column : layout.columns) {
        out << "  " << std::left << std::setw(28) << column.name << ' ' << std::setw(8) << column.unit << ' '
            << column.meaning << " (" << column.source << ")\n";
    }
}

}  // namespace

void write_result_tables(const std::string& table, std::ostream& out) {
    bool found = false;
    std::vector<std::string> names;
    for (const Kind& kind : kinds) {
        if (table.empty()) {
            out << "Tables of " << kind.name << '\n';
        }
        for (const TableLayout& layout : kind.layouts()) {
            const std::string name = layout.file.substr(0, layout.file.rfind('.'));
            names.push_back(name);
            if (table.empty()) {
                out << "  " << std::left << std::setw(26) << layout.file << " a row is " << layout.row
                    << '\n';
            } else if (table == name || find_layout({layout}, table) != nullptr ||
                       find_layout({layout}, table + ".csv") != nullptr) {
                out << (found ? "\n" : "");
                write_columns(layout, kind.name, out);
                found = true;
            }
        }
    }
    if (!table.empty() && !found) {
        const std::string nearest = config::nearest_word(table, names);
        config::fail(config::ExitCode::settings, {}, "table " + config::in_quotes(table),
                     nearest.empty() ? "one of `bannwald info tables`" : config::in_quotes(nearest));
    }
}

}  // namespace coupling
