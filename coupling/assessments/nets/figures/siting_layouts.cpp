#include "coupling/assessments/nets/figures/siting_layouts.hpp"

#include "coupling/results/tables/figure_columns.hpp"

namespace coupling::siting {
namespace {

constexpr const char* of_falls = "simulated";
constexpr const char* of_counts = "counted over the simulated rocks";
constexpr const char* rules = "coupling/assessments/nets/README.md";
constexpr const char* classes = "net_classes.csv (ETAG 027, EAD 340059-00-0106)";
constexpr const char* from_lines = "input --nets";

Column line_column() {
    return {"line", "text", "name of the line to protect", from_lines};
}

std::vector<Column> net_columns() {
    return {{"class", "text", "energy class of the net; empty: too few rocks for an estimate", classes},
            {"capacity_kj", "kJ", "maximum energy level of the class; of the open class the energy needed",
             classes},
            {"height_m", "m", "height of the net; radius of the rocks and margins of guidelines come on top",
             rules},
            {"net_length_m", "m", "length of the net in plan", rules}};
}

TableLayout stretches() {
    const std::vector<Column> first{
        line_column(),
        {"stretch", "-", "number of the stretch along the line", rules},
        {"from_m", "m", "where it begins, along the line from its first corner", rules},
        {"to_m", "m", "where it ends", rules},
        cover_column(),
        {"rocks", "-", "rocks that come to the stretch where no net stands", of_counts},
        {"rocks_percent", "%", "share of the rocks that come to the line", of_counts},
        {"energy_percent", "%", "share of the energy that comes to the line", of_counts},
        {"energy_95_kj", "kJ", "95th percentile of their energies (empty: fewer than 20 rocks)", of_falls},
        {"energy_max_kj", "kJ", "largest of their energies", of_falls},
        {"azimuth_deg", "deg", "direction upslope, clockwise from north; empty: none", rules},
        {"azimuth_from", "text", "where it comes from: rocks, gradient or given (--azimuth)", rules},
        {"distance_m", "m", "of the best candidate, in plan upslope of the stretch; empty: none is best",
         rules}};
    const std::vector<Column> last{
        {"kept", "-", "rocks that the best net holds, of those that come to the stretch", of_counts},
        {"kept_percent", "%", "share of them", of_counts},
        {"kept_low_percent", "%", "lower end of its 95 % interval", "Clopper and Pearson 1934"},
        {"kept_high_percent", "%", "upper end of its 95 % interval", "Clopper and Pearson 1934"},
        {"left_rocks", "-", "rocks that it leaves", of_counts},
        {"left_energy_percent", "%", "share of the energy that it leaves", of_counts},
        {"left_max_kj", "kJ", "largest energy that it leaves", of_falls},
        {"ties", "text", "distances [m] of the candidates that are as good", rules}};
    return {"net_stretches.csv", "a stretch of a line where works are needed",
            together(first, net_columns(), last)};
}

TableLayout candidates() {
    const std::vector<Column> first{line_column(),
                                    {"stretch", "-", "number of the stretch along the line", rules},
                                    {"distance_m", "m", "in plan, upslope of the stretch", rules},
                                    cover_column()};
    const std::vector<Column> last{
        {"rocks", "-", "rocks that come to the stretch where no net stands", of_counts},
        {"crossing", "-", "those of them that cross the line of the candidate before", of_counts},
        {"kept", "-", "those that the net holds", of_counts},
        {"kept_percent", "%", "share of the rocks that come to the stretch", of_counts},
        {"kept_low_percent", "%", "lower end of its 95 % interval", "Clopper and Pearson 1934"},
        {"kept_high_percent", "%", "upper end of its 95 % interval", "Clopper and Pearson 1934"},
        {"left_rocks", "-", "rocks that it leaves", of_counts},
        {"residual_kj", "kJ", "energy that it leaves to the stretch, per rock that fell", of_counts},
        {"left_energy_percent", "%", "share of the energy that comes to the stretch", of_counts},
        {"left_max_kj", "kJ", "largest energy that it leaves", of_falls},
        {"reached", "-",
         "all rocks that cross the line between the ends of the net, also those that would "
         "stop before the line to protect",
         of_counts},
        {"energy_95_kj", "kJ", "95th percentile of their energies (empty: fewer than 20 rocks)", of_falls},
        {"energy_max_kj", "kJ", "largest of their energies", of_falls},
        {"keeps_wanted", "text", "yes: it keeps the wanted share of the rocks (nets.wanted_share)", rules},
        {"best", "text", "yes: the best candidate of the stretch", rules},
        {"tie", "text", "yes: as good as the best", rules}};
    return {"net_candidates.csv",
            "a candidate upslope of a stretch on one slope; the design rests on the slope with forest "
            "where there is one",
            together(first, net_columns(), last)};
}

TableLayout along() {
    return {
        "net_along.csv",
        "a piece of a line, 10 m long, on one slope",
        {line_column(),
         {"from_m", "m", "where it begins, along the line from its first corner", "definition"},
         {"to_m", "m", "where it ends", "definition"},
         cover_column(),
         {"rocks", "-", "rocks that come to it where no net stands", of_counts},
         {"energy_per_1000_kj", "kJ", "sum of their energies per 1000 rocks that fell", of_counts},
         {"energy_mean_kj", "kJ", "mean of their energies", of_falls},
         {"energy_95_kj", "kJ", "95th percentile of their energies (empty: fewer than 20 rocks)", of_falls},
         {"energy_max_kj", "kJ", "largest of their energies", of_falls},
         {"left_rocks", "-", "rocks that come to it past the nets of nets.csv together", of_counts},
         {"left_energy_per_1000_kj", "kJ", "sum of their energies per 1000 rocks that fell", of_counts},
         {"needed", "text", "yes: it belongs to a stretch where works are needed", rules}}};
}

}  // namespace

const std::vector<TableLayout>& siting_layouts() {
    static const std::vector<TableLayout> layouts{stretches(), candidates(), along()};
    return layouts;
}

}  // namespace coupling::siting
