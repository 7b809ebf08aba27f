#include "coupling/assessments/nets/net_trial.hpp"

#include <sstream>

#include "config/text/joined.hpp"
#include "coupling/assessments/nets/figures/net_layers.hpp"
#include "coupling/assessments/nets/figures/net_summary.hpp"
#include "coupling/assessments/nets/figures/net_tables.hpp"
#include "coupling/assessments/nets/figures/net_try.hpp"
#include "coupling/assessments/nets/figures/net_words.hpp"
#include "coupling/assessments/nets/net_trial_page.hpp"
#include "coupling/inputs/places/line_through.hpp"
#include "coupling/results/tables/figure_columns.hpp"
#include "coupling/results/tables/text_layout.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/short_run.hpp"

namespace coupling {
namespace {

namespace fs = std::filesystem;

constexpr const char* package_name = "net_try.gpkg";

/// A rock that broke a net.
struct BrokenNet {
    const NetRecord& record;
    const NetOfRock& of;
};

TableOf<BrokenNet> inexact_table() {
    return {"net_inexact.csv",
            "",
            "a rock that breaks through a net on one slope",
            {{"rock", "number of the rock; what it does behind the net is not known",
              [](const auto& row) { return row.of.rock; }},
             {cover_column(), [](const auto& row) { return name_of(row.of.cover); }},
             {net_name_column(), [](const auto& row) { return row.record.name; }}}};
}

void write_inexact(std::ostream& out, std::span<const NetRecord> nets, std::span<const NetOfRock> broken) {
    inexact_table().write_to(out, [&](auto& rows) {
        for (const NetOfRock& one : broken) {
            rows.add({nets[one.net], one});
        }
    });
}

void print(const std::vector<NetRecord>& nets, const std::vector<NetFigures>& figures, const TriedNets& tried,
           const DesignSettings& design, std::ostream& out) {
    for (const NetFigures& of : figures) {
        out << in_words(nets[of.net], of, design) << '\n';
    }
    print_wrapped(out, "", design_rule_in_words(design));
    if (!tried.broken.empty()) {
        out << tried.broken.size()
            << " rocks break through a net; what they do behind it is not known here and left out "
               "(net_inexact.csv): run the scenario with these nets for it\n";
    }
}

}  // namespace

TableLayout net_inexact_layout() {
    return inexact_table();
}

std::vector<TableLayout> net_try_layouts() {
    return together(net_layouts(), std::vector{net_inexact_layout()});
}

namespace {

constexpr const char* nets_sentence =
    "Each net on each slope: rocks that reach it, held, over, below, broken through; energy and height with "
    "intervals; the design that its rocks ask for.";
constexpr const char* crossings_sentence =
    "Each rock in the plane of each net: where, how high, how fast, what became of it.";

/// Tables of the tried nets, and the same as layers.
void write_tried(const NetTryRequest& request, std::span<const NetRecord> nets,
                 std::span<const NetFigures> figures, const TriedNets& tried, NetPathsReader& paths,
                 const std::vector<std::string>& remarks, ShortRun& results) {
    const Eigen::Vector2d origin_m = paths.terrain().origin_m();
    std::ostringstream of_nets;
    write_nets(of_nets, nets, figures, paths.head().design);
    std::ostringstream of_crossings;
    write_net_crossings(of_crossings, nets, tried.rows, origin_m);
    results.add("nets.csv", nets_sentence, [&](std::ostream& table) { table << of_nets.view(); });
    results.add("net_needs.csv", "What each energy class would hold at the height of the design of each net.",
                [&](std::ostream& table) { write_net_needs(table, nets, figures); });
    results.add("net_crossings.csv", crossings_sentence,
                [&](std::ostream& table) { table << of_crossings.view(); });
    results.add("net_inexact.csv", "Rocks that broke a net: what they do behind it is not known.",
                [&](std::ostream& table) { write_inexact(table, nets, tried.broken); });

    Lines lines;
    for (const NetFigures& of : figures) {
        lines.push_back(nets[of.net].net.line_m);
    }
    std::vector<Eigen::Vector2d> places_m;
    for (const NetRow& row : tried.rows) {
        places_m.emplace_back(row.crossing.x_m + origin_m.x(), row.crossing.y_m + origin_m.y());
    }
    geopackage::GeoPackage package{results.path() / package_name,
                                   geopackage::spatial_reference(projection_of_run(request.run))};
    const std::vector<TableLayout> layouts = net_layouts();
    add_lines(package, "nets", nets_sentence, {layouts.front(), of_nets.str(), lines}, origin_m);
    add_points(package, "net_crossings", crossings_sentence, layouts.back(), of_crossings.str(), places_m);
    package.close();
    results.add_written({package_name, "Nets and crossings as layers for QGIS."});
    results.add("report.html", "What the nets hold, and maps on which they can be moved.",
                [&](std::ostream& page) {
                    write_net_trial_page(page, {nets, figures, remarks}, paths, head_of(request.run),
                                         results.files_with_those_to_come());
                });
}

}  // namespace

void try_nets(const NetTryRequest& request, std::ostream& out) {
    NetPathsReader paths = paths_of_run(request.run);
    std::vector<std::string> remarks;
    const std::vector<NetRecord> nets =
        nets_on(request.nets, {paths.terrain(), projection_of_run(request.run)}, Standing::together, remarks);
    const std::vector<rockfall::Target> targets =
        houses_and_lines_of_run(request.run, paths.terrain(), remarks);
    const auto runs_through_house = [](const auto& line_m, const rockfall::Target& target) {
        return target.is_area && runs_over(line_m, target);
    };
    for (const NetRecord& net : nets) {
        const std::string name = config::joined("warning: net ", config::in_quotes(net.name));
        if (const auto met = targets_under(net.net.line_m, targets, runs_through_house); !met.empty()) {
            remarks.push_back(
                config::joined(name, " runs through the house ", config::in_quotes(met.front()->id)));
        }
        if (const auto met = targets_under(net.net.line_m, targets, runs_across); !met.empty()) {
            remarks.push_back(config::joined(name, " crosses the line ", config::in_quotes(met.front()->id),
                                             ": end it there if that is a road"));
        }
    }
    const fs::path folder = request.out.empty() ? request.run / "net_try" : request.out;
    ShortRun::look_at(
        folder, "net try",
        {"report.html", "nets.csv", "net_needs.csv", "net_crossings.csv", "net_inexact.csv", package_name},
        request.overwrite);
    std::vector<rockfall::Net> walls;
    for (const NetRecord& record : nets) {
        walls.push_back(record.net);
    }
    const rockfall::NetIndex index{walls};
    TriedNets tried;
    paths.each([&](const StoredPath& path) { try_nets(index, paths.terrain(), path, tried); });

    const PathsHead& head = paths.head();
    const std::vector<NetFigures> figures = figures_of_tried(nets, tried, head.rocks, head);
    const InterruptGuard until_written;
    ShortRun results{folder};
    write_tried(request, nets, figures, tried, paths, remarks, results);
    results.publish({.kind = "net try",
                     .run = run_of_paths(request.run, request.nets, head),
                     .figures = json_of(nets, figures),
                     .inputs = head.inputs,
                     .warnings = remarks,
                     .excel_decimal = excel_decimal_of(head)},
                    net_try_layouts());
    if (!request.quiet) {
        for (const std::string& remark : remarks) {
            out << remark << '\n';
        }
        print(nets, figures, tried, head.design, out);
        out << (folder / "report.html").string() << '\n' << folder.string() << '\n';
    }
}

}  // namespace coupling
