#include "config/text/numbers.hpp"
#include "coupling/assessments/nets/net_place.hpp"
#include "coupling/assessments/nets/net_trial.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"

namespace coupling {
namespace {

constexpr const char* net_help = R"(bannwald net try DIR --nets FILE

Looks at the nets of a table (as nets.file of a scenario) with the paths that a run with nets.keep_paths = yes
has stored in DIR/net_paths.bin, and writes nets.csv, net_needs.csv and net_crossings.csv of them, and
report.html, on which the nets can be moved. Paths are
those of a slope without nets: what nets hold or let pass is that of a run with them, row by row. Behind a net
that a rock breaks nothing is known: these rocks stand in net_inexact.csv, and inexact_rocks counts those that
may reach a net.
  --nets FILE           table of nets
  --out DIR             folder of the tables (default: DIR/net_try)
  --overwrite           replaces tables that the folder holds

bannwald net place DIR --nets FILE [--distances 0,10,20] [--azimuth 270]

Says where along lines to protect, such as a road, nets are needed, and which: stretches, candidates upslope
of them with energy class, height and length, and what is left below. FILE is a table or layer of lines as it
is (targets.csv, roads.gpkg|layer, roads.shp); nothing about nets needs to stand in it. Writes report.html with
map and curve, net_stretches.csv, net_candidates.csv, net_along.csv, net_place.gpkg, and nets.csv with the best
net of each stretch, ready for nets.file.
With columns of nets (height_m, capacity_kj or class) the net of each line is also moved upslope as a whole:
net_places.csv says for each place which rocks it would keep from the line, and nets.csv has the best place.
  --nets FILE           table or layer of lines to protect
  --distances 0,10,20   in plan, m (default: 10 to 150 in steps of 10)
  --azimuth DEG         the way upslope, clockwise from north (default: against the mean direction of the
                        rocks that reach the line; where none does, along the gradient of the ground)
  --out DIR             folder of the results (default: DIR/net_place)
  --overwrite           replaces files that the folder holds
)";

std::vector<std::string> action_words() {
    return {"try", "place"};
}

std::optional<double> azimuth_of(const Arguments& arguments) {
    if (!arguments.has("azimuth")) {
        return std::nullopt;
    }
    constexpr config::NumberRange range{.low = 0.0, .high = 360.0};
    const auto azimuth_deg = config::parse_number(arguments.text("azimuth"));
    if (!azimuth_deg || !range.contains(*azimuth_deg)) {
        refuse_usage("--azimuth " + config::in_quotes(arguments.text("azimuth")),
                     config::describe("a number", range) + " deg, clockwise from north");
    }
    return azimuth_deg;
}

/// `net try DIR --nets FILE` and `net place DIR --nets FILE`.
int net(const Arguments& arguments, const Call& call) {
    const std::vector<std::string>& words = arguments.words();
    constexpr const char* form = "`bannwald net try DIR --nets FILE`, or place instead of try";
    if (words.empty() || (words.front() != "try" && words.front() != "place")) {
        refuse_usage(words.empty() ? "`bannwald net` alone" : "`bannwald net " + words.front() + '`', form);
    }
    const std::string& action = words.front();
    if (words.size() != 2 || !arguments.has("nets")) {
        refuse_usage("`bannwald net " + action + "` without " + (words.size() != 2 ? "one folder" : "--nets"),
                     form);
    }
    if (action == "try") {
        for (const std::string option : {"distances", "azimuth"}) {
            if (arguments.has(option)) {
                refuse_usage("--" + option + " of `bannwald net try`", "it with `bannwald net place`");
            }
        }
        try_nets({.run = words[1],
                  .nets = arguments.text("nets"),
                  .out = arguments.out(),
                  .overwrite = arguments.overwrite(),
                  .quiet = arguments.quiet()},
                 call.out);
        return static_cast<int>(config::ExitCode::done);
    }
    place_nets({.run = words[1],
                .nets = arguments.text("nets"),
                .out = arguments.out(),
                .distances_m = arguments.rising_metres("distances", {.low = 0.0, .high = 5000.0}),
                .azimuth_deg = azimuth_of(arguments),
                .overwrite = arguments.overwrite(),
                .quiet = arguments.quiet()},
               call.out);
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace

Command net_command() {
    return {
        .name = "net",
        .overview = R"(  bannwald net try DIR --nets FILE     evaluates other nets without another simulation
  bannwald net place DIR --nets FILE   where along a road nets are needed, and which
)",
        .help = net_help,
        .argument = "",
        .options = {option_with_value("nets", {Completion::Names::files}), option_with_value("distances"),
                    option_with_value("azimuth"), out_folder_option(), overwrite_option()},
        .completion = {Completion::Names::folders, action_words},
        .run = net};
}

}  // namespace coupling
