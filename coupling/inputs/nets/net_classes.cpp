#include "coupling/inputs/nets/net_classes.hpp"

#include <algorithm>
#include <cmath>

#include "config/data/shipped_tables.hpp"
#include "config/table/table.hpp"

namespace coupling {
namespace {

std::vector<NetClass> read_classes() {
    const config::Table table = config::read_shipped_table("net_classes.csv");
    config::Problems problems;
    std::vector<NetClass> classes;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        NetClass& entry = classes.emplace_back();
        entry.name = table.text(row, "class");
        if (!table.text(row, "mel_kj").empty()) {
            entry.mel_kj = table.number(row, "mel_kj", {.low = 0.0, .low_excluded = true}, problems)
                               .value_or(entry.mel_kj);
        }
        if (!table.text(row, "sel_kj").empty()) {
            entry.sel_kj = table.number(row, "sel_kj", {.low = 0.0, .low_excluded = true}, problems);
        }
    }
    problems.throw_if_any();
    return classes;
}

}  // namespace

const std::vector<NetClass>& net_classes() {
    static const std::vector<NetClass> classes = read_classes();
    return classes;
}

double strongest_closed_kj() {
    double strongest_kj = 0.0;
    for (const NetClass& known : net_classes()) {
        strongest_kj = std::isfinite(known.mel_kj) ? std::max(strongest_kj, known.mel_kj) : strongest_kj;
    }
    return strongest_kj;
}

const NetClass& class_for(double energy_kj) {
    const std::vector<NetClass>& classes = net_classes();
    return *std::find_if(classes.begin(), classes.end(),
                         [&](const NetClass& c) { return energy_kj <= c.mel_kj; });
}

}  // namespace coupling
