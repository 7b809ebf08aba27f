#include "coupling/assessments/nets/figures/net_tables.hpp"

#include <cmath>
#include <limits>

#include "config/units/constants.hpp"
#include "coupling/assessments/nets/figures/net_layouts.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::percent;

void add_share(CsvRow& row, const Share& share) {
    row.whole(share.part).number<4>(percent * share.value);
    if (share.whole == 0) {
        row.empty().empty();
        return;
    }
    row.number<4>(percent * share.interval.low).number<4>(percent * share.interval.high);
}

void add_estimate(CsvRow& row, const QuantileEstimate& estimate) {
    row.number<3>(estimate.value);
    if (std::isnan(estimate.value)) {
        row.empty().empty();
        return;
    }
    row.number<3>(estimate.interval.low).number<3>(estimate.interval.high);
}

void add_quantity(CsvRow& row, const NetQuantity& quantity) {
    row.number<3>(quantity.mean).number<3>(quantity.p50).number<3>(quantity.p90);
    add_estimate(row, quantity.p95);
    add_estimate(row, quantity.p99);
    row.number<3>(quantity.max);
}

}  // namespace

void write_nets(std::ostream& out, std::span<const NetRecord> nets, std::span<const NetFigures> figures,
                double wanted_share) {
    TableRows row{out, net_layouts(), "nets.csv"};
    for (const NetFigures& of : figures) {
        const NetRecord& record = nets[of.net];
        row.text(record.name).text(name_of(of.cover)).text(record.energy_class);
        row.number<1>(record.net.capacity_j / j_per_kj).number<2>(record.net.height_m);
        row.number<2>(record.net.gap_m).number<2>(length_m(record.net)).whole(of.reached.whole);
        add_share(row, of.reached);
        row.whole(of.inexact);
        for (const Share& share : of.outcome) {
            add_share(row, share);
        }
        add_quantity(row, of.energy_kj);
        add_quantity(row, of.height_m);
        row.number<2>(percent * wanted_share);
        if (of.needs.empty()) {
            row.empty().empty().empty().empty().empty().empty();
        } else {
            const NetNeed& need = of.needs[of.recommended];
            row.text(need.energy_class).number<3>(of.energy_needed_kj);
            row.number<1>(need.height_m.value_or(std::numeric_limits<double>::quiet_NaN()));
            row.number<4>(percent * need.held.value).number<4>(percent * need.held.interval.low);
            row.number<4>(percent * need.held.interval.high);
        }
        row.end();
    }
}

void write_net_needs(std::ostream& out, std::span<const NetRecord> nets,
                     std::span<const NetFigures> figures) {
    TableRows row{out, net_layouts(), "net_needs.csv"};
    for (const NetFigures& of : figures) {
        for (std::size_t i = 0; i < of.needs.size(); ++i) {
            const NetNeed& need = of.needs[i];
            row.text(nets[of.net].name).text(name_of(of.cover)).text(need.energy_class);
            row.number<0>(need.mel_kj);
            row.number<1>(need.height_m.value_or(std::numeric_limits<double>::quiet_NaN()));
            row.number<4>(percent * need.held.value).text(i == of.recommended ? "yes" : "no");
            row.end();
        }
    }
}

void write_net_crossings(std::ostream& out, std::span<const NetRecord> nets, std::span<const NetRow> rows,
                         const Eigen::Vector2d& origin_m) {
    TableRows row{out, net_layouts(), "net_crossings.csv"};
    for (const NetRow& entry : rows) {
        const rockfall::NetCrossingRecord& crossing = entry.crossing;
        row.whole(entry.rock).text(name_of(entry.cover)).text(nets[crossing.net].name);
        row.text(name_of(crossing.outcome)).text(crossing.first ? "yes" : "no");
        row.number<2>(static_cast<double>(crossing.along_m))
            .number<3>(static_cast<double>(crossing.height_m));
        row.number<2>(static_cast<double>(crossing.x_m) + origin_m.x());
        row.number<2>(static_cast<double>(crossing.y_m) + origin_m.y());
        row.number<3>(static_cast<double>(crossing.energy_j) / j_per_kj);
        row.number<3>(static_cast<double>(crossing.translational_j) / j_per_kj);
        row.number<3>(static_cast<double>(crossing.speed_mps));
        row.end();
    }
}

std::vector<NetFigures> net_figures(const RunResults& results) {
    std::vector<NetFigures> all;
    for (const Cover cover : covers_of(results)) {
        const std::vector<NetFigures> of_slope =
            net_figures(results.site.nets, results.net_rows, cover, results.tally.runs[index_of(cover)].rocks,
                        results.scenario.nets.wanted_share);
        all.insert(all.end(), of_slope.begin(), of_slope.end());
    }
    return all;
}

std::vector<WrittenFile> write_net_tables(const RunResults& results, const std::filesystem::path& folder) {
    const std::vector<NetRecord>& nets = results.site.nets;
    if (nets.empty()) {
        return {};
    }
    const std::vector<NetFigures> figures = net_figures(results);
    OutFile overview{folder / "tables/nets.csv"};
    write_nets(overview.stream(), nets, figures, results.scenario.nets.wanted_share);
    overview.close();
    OutFile needs{folder / "tables/net_needs.csv"};
    write_net_needs(needs.stream(), nets, figures);
    needs.close();
    OutFile crossings{folder / "tables/net_crossings.csv"};
    write_net_crossings(crossings.stream(), nets, results.net_rows, results.site.origin_m());
    crossings.close();
    return {
        {"tables/nets.csv",
         "Each net on each slope: rocks that reach it, held, over, below, broken through; energy and height "
         "with intervals; class and height needed."},
        {"tables/net_needs.csv", "How high each energy class must be at each net to hold the wanted share."},
        {"tables/net_crossings.csv",
         "Each rock in the plane of each net: where, how high, how fast, what "
         "became of it."}};
}

}  // namespace coupling
