#include "config/data/shipped_tables.hpp"
#include "coupling/exchange/regimes/shipped.hpp"
#include "coupling/program/actions/info.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"

namespace coupling {
namespace {

constexpr const char* info_help = R"(bannwald info FILE
bannwald info tables [TABLE]
bannwald info inputs [TABLE]

Prints what a grid (frame, range, NODATA, projection), a folder, list or VRT of tiles, a mesh, a layer
or a table (columns, rows, units) holds. The name of a shipped table prints that table:
  bannwald info surfaces           ground types with restitution
  bannwald info stopping           their stopping probabilities by rock diameter
  bannwald info pir3d_soils        soils of the ground types, for motion models that use them
  bannwald info rigid_grounds      classes of ground for models whose rocks have a shape
  bannwald info parameter_widths   what is not known of a fall, and how little
  bannwald info ground_words       words in names of grounds, and the types that init proposes for them
  bannwald info net_classes        energy classes of rockfall nets
  bannwald info hazard_matrix      hazard levels by energy and return period
  bannwald info risk_curves        lethality and damage by energy of the block
  bannwald info tree_resistance    species with the energy they take
  bannwald info timber_prices      what wood brings and costs; also work_costs
  bannwald info regimes            names of the shipped regimes and the columns of a regime
The tables that a run writes, with unit, meaning and source of every column:
  bannwald info tables             all of them
  bannwald info tables targets     the columns of targets.csv
The tables that a run reads, with unit, values and meaning of every column:
  bannwald info inputs             all of them
  bannwald info inputs trees       the columns of the table that trees.file names
)";

/// Names of what `info` prints beside files.
std::vector<std::string> printed_names() {
    std::vector<std::string> names{"tables", "inputs", "regimes"};
    for (const std::string& table : config::shipped_table_names()) {
        names.push_back(table.substr(0, table.rfind('.')));
    }
    const std::vector<std::string> regimes = shipped_regime_names();
    names.insert(names.end(), regimes.begin(), regimes.end());
    return names;
}

/// A file, or `tables` or `inputs` and perhaps the name of one.
int info(const Arguments& arguments, const Call& call) {
    const std::vector<std::string>& words = arguments.words();
    const bool is_of_table = words.size() == 2 && (words.front() == "tables" || words.front() == "inputs");
    write_info(is_of_table ? words.front() : arguments.only_word(), is_of_table ? words.back() : "",
               call.out);
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace

Command info_command() {
    return {
        .name = "info",
        .overview =
            R"(  bannwald info FILE                   prints what a grid or a table holds; `info tables`, `info inputs`: columns
)",
        .help = info_help,
        .argument = "a file",
        .options = {},
        .completion = {Completion::Names::files, printed_names},
        .run = info};
}

}  // namespace coupling
