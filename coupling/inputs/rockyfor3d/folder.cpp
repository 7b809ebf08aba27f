#include "coupling/inputs/rockyfor3d/folder.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <map>

#include "config/errors/input_error.hpp"
#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/read_file.hpp"

namespace coupling::rockyfor3d {
namespace {

using config::joined;

namespace fs = std::filesystem;
using config::ExitCode;
using config::NumberRange;
using config::Raster;

constexpr std::size_t most_told = 20;  ///< faulty lines of a tree file

std::string size_of(const config::GridFrame& frame) {
    return joined(std::to_string(frame.columns), " x ", std::to_string(frame.rows), " cells of ",
                  config::to_text(frame.cell_width_m), " m from (",
                  config::place_in_words(frame.x_west_m, frame.y_south_m), ")");
}

/// Reads the files of one folder and keeps what is wrong with them.
class Reader {
public:
    explicit Reader(const fs::path& folder) : folder_{folder} {
        if (!is_folder(folder)) {
            config::fail(ExitCode::file, {.file = folder.string()}, "no folder of this name",
                         "a folder with the inputs of Rockyfor3D");
        }
        for (const fs::path& entry : entries_of(folder)) {
            if (is_file(entry)) {
                const std::string name = entry.filename().string();
                names_[config::in_lower_case(name)] = name;
            }
        }
    }

    [[nodiscard]] bool has(const std::string& name) const { return names_.contains(name); }
    /// The file as it is written there.
    [[nodiscard]] fs::path path_of(const std::string& name) const {
        const auto found = names_.find(name);
        return folder_ / (found == names_.end() ? name : found->second);
    }
    [[nodiscard]] config::Problems& problems() { return problems_; }

    std::optional<Raster<double>> grid(const std::string& name) {
        try {
            const fs::path path = path_of(name);
            const FileBytes bytes = open_file(path, {.file = path.string()}, "a raster of Rockyfor3D");
            read_.push_back(path.filename().string());
            formats::PlacedGrid read = formats::read_grid_file(
                bytes.text(), path.string(), [](const std::string&) { return std::string_view{}; });
            for (const std::string& remark : read.remarks) {
                remarks_.push_back(joined(path.filename().string(), ": ", remark, "."));
            }
            return std::move(read.raster);
        } catch (const config::InputError& error) {
            problems_.add(error);
            return std::nullopt;
        }
    }

    /// A raster that has to be there, on the frame of the DEM, each value in its range or NODATA.
    Raster<double> on(const Raster<double>& dem, const std::string& name, NumberRange range,
                      bool whole = false, const std::string& advice = "") {
        const std::optional<Raster<double>> raster = grid(name);
        if (!raster) {
            return Raster<double>{dem.frame, std::nan("")};
        }
        if (!config::same_place(dem.frame, raster->frame)) {
            problems_.add(ExitCode::data, {.file = path_of(name).string()}, size_of(raster->frame),
                          joined("the frame of the DEM: ", size_of(dem.frame)));
            return Raster<double>{dem.frame, std::nan("")};
        }
        check_values(*raster, name, range, whole, advice);
        return {*raster};
    }

    std::vector<FileTree> tree_file(const std::string& name);

    [[nodiscard]] std::vector<std::string> files_read() const { return read_; }
    [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }
    [[nodiscard]] std::vector<std::string> others() const {
        std::vector<std::string> names;
        for (const auto& [small, name] : names_) {
            if (std::find(read_.begin(), read_.end(), name) == read_.end()) {
                names.push_back(name);
            }
        }
        return names;
    }
    void mark_read(const std::string& name) { read_.push_back(path_of(name).filename().string()); }

private:
    void check_values(const Raster<double>& raster, const std::string& name, NumberRange range, bool whole,
                      const std::string& advice) {
        std::size_t faults = 0;
        std::size_t first = 0;
        for (std::size_t i = 0; i < raster.values.size(); ++i) {
            const double value = raster.values[i];
            if (!std::isnan(value) && (!range.contains(value) || (whole && value != std::floor(value)))) {
                first = faults++ == 0 ? i : first;
            }
        }
        if (faults > 0) {
            const config::Cell cell = raster.frame.cell_of(first);
            problems_.add(ExitCode::data, {.file = path_of(name).string()},
                          joined(std::to_string(faults), " cells out of range, such as ",
                                 config::to_text(raster.values[first]), " in row ",
                                 std::to_string(cell.row + 1), ", column ", std::to_string(cell.column + 1)),
                          config::describe(whole ? "whole numbers" : "numbers", range), advice);
        }
    }

    fs::path folder_;
    std::map<std::string, std::string> names_;  ///< by name in small letters
    std::vector<std::string> read_;
    std::vector<std::string> remarks_;
    config::Problems problems_;
};

/// Numbers of a line, apart by blanks, tabs, commas or semicolons; nothing if one of them is none.
std::optional<std::vector<double>> numbers_of(std::string_view line) {
    constexpr std::string_view apart = " \t,;\r";
    std::vector<double> numbers;
    for (std::size_t at = line.find_first_not_of(apart); at < line.size();) {
        const std::size_t end = std::min(line.find_first_of(apart, at), line.size());
        const auto number = config::parse_number(line.substr(at, end - at));
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
        at = line.find_first_not_of(apart, end);
    }
    return numbers;
}

std::vector<FileTree> Reader::tree_file(const std::string& name) {
    constexpr NumberRange dbh_range{.low = 0.0, .high = 250.0, .low_excluded = true};
    const fs::path path = path_of(name);
    const FileBytes bytes = open_file(path, {.file = path.string()}, "a tree file of Rockyfor3D");
    mark_read(name);
    std::vector<FileTree> trees;
    const std::string_view text = bytes.text();
    std::size_t faults = 0;
    std::size_t number = 0;
    std::size_t most_numbers = 3;
    for (std::size_t at = 0; at < text.size() && faults < most_told;) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        at = end + 1;
        ++number;
        const auto values = numbers_of(line);
        if (!values && number == 1) {
            continue;  // a line of names
        }
        if (values && values->empty()) {
            continue;
        }
        if (!values || values->size() < 3 || !dbh_range.contains((*values)[2])) {
            problems_.add(ExitCode::data, {path.string(), number, 0}, config::in_quotes(line),
                          "x, y and DBH in cm, (0, 250]");
            ++faults;
            continue;
        }
        most_numbers = std::max(most_numbers, values->size());
        trees.push_back({(*values)[0], (*values)[1], (*values)[2]});
    }
    if (most_numbers > 3) {
        remarks_.push_back(joined(path.filename().string(), ": x, y and DBH are read, not the other ",
                                  std::to_string(most_numbers - 3),
                                  most_numbers == 4 ? " column." : " columns."));
    }
    return trees;
}

/// What the sources of a run take (coupling/inputs/release/source_start): other blocks would be refused
/// later, in words of another file.
constexpr NumberRange axis_range_m{.low = 0.01, .high = 20.0};
constexpr NumberRange density_range_kgpm3{.low = 1000.0, .high = 5000.0};

/// Each source cell has a block, each cell of the DEM a ground.
void check_cells(const Folder& folder, Reader& reader) {
    std::size_t sources = 0;
    std::size_t without_block = 0;
    std::size_t too_light = 0;
    std::size_t without_ground = 0;
    for (std::size_t i = 0; i < folder.dem.values.size(); ++i) {
        const bool has_ground = folder.soil_type.values[i] >= 0.0 && folder.rg70.values[i] >= 0.0 &&
                                folder.rg20.values[i] >= 0.0 && folder.rg10.values[i] >= 0.0;
        without_ground += !std::isnan(folder.dem.values[i]) && !has_ground ? 1 : 0;
        if (folder.rock_density.values[i] > 0.0) {
            ++sources;
            const bool has_block =
                axis_range_m.contains(folder.d1.values[i]) && axis_range_m.contains(folder.d2.values[i]) &&
                axis_range_m.contains(folder.d3.values[i]) && folder.shape.values[i] >= 1.0;
            without_block += has_block ? 0 : 1;
            too_light += density_range_kgpm3.contains(folder.rock_density.values[i]) ? 0 : 1;
        }
    }
    const auto file = [&](const char* name) { return config::Place{.file = reader.path_of(name).string()}; };
    if (sources == 0) {
        reader.problems().add(ExitCode::data, file("rockdensity.asc"), "no cell above 0", "a source");
    }
    if (without_block > 0) {
        reader.problems().add(
            ExitCode::data, file("blshape.asc"),
            joined(std::to_string(without_block), " source cells without a block"),
            "d1, d2, d3 from 0.01 to 20 m and blshape 1 to 4 wherever rockdensity is above 0");
    }
    if (too_light > 0) {
        reader.problems().add(ExitCode::data, file("rockdensity.asc"),
                              joined(std::to_string(too_light), " source cells of less than 1000 kg/m3"),
                              "densities of rock in kg/m3, 1000 to 5000",
                              "multiply by 1000 if they are t/m3");
    }
    if (without_ground > 0) {
        reader.problems().add(ExitCode::data, file("soiltype.asc"),
                              joined(std::to_string(without_ground), " cells of the DEM without a ground"),
                              "soiltype, rg70, rg20 and rg10 wherever the DEM has a height");
    }
}

/// The median of the values above 0 and below `below`; 0 without any.
double median_within(const std::vector<double>& values, double below) {
    std::vector<double> within;
    std::copy_if(values.begin(), values.end(), std::back_inserter(within),
                 [&](double value) { return value > 0.0 && value < below; });
    if (within.empty()) {
        return 0.0;
    }
    const auto middle = within.begin() + static_cast<std::ptrdiff_t>(within.size() / 2);
    std::nth_element(within.begin(), middle, within.end());
    return *middle;
}

/// Obstacles that most of a slope has are no higher than a man [choice]: coarse block fields have 1 m. 100 m
/// is the height where every rock stops.
void check_roughness(const Folder& folder, Reader& reader) {
    constexpr double highest_median_m = 2.5;
    constexpr double stops_all_m = 100.0;
    constexpr std::array<const char*, 3> names{"rg70.asc", "rg20.asc", "rg10.asc"};
    const std::array<const Raster<double>*, 3> rasters{&folder.rg70, &folder.rg20, &folder.rg10};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double median_m = median_within(rasters[i]->values, stops_all_m);
        if (median_m > highest_median_m) {
            reader.problems().add(
                ExitCode::data, {.file = reader.path_of(names[i]).string()},
                joined("obstacles of ", config::to_text(median_m), " m on half of the ground"),
                "heights of obstacles in m, seldom above 1", "divide by 100 if they are centimetres");
        }
    }
}

/// Whether on most of the rough ground the height met in 70 % of the contacts is above that met in 10 %.
bool roughness_looks_reversed(const Folder& folder) {
    std::size_t rising = 0;
    std::size_t falling = 0;
    for (std::size_t i = 0; i < folder.rg70.values.size(); ++i) {
        rising += folder.rg70.values[i] < folder.rg10.values[i] ? 1 : 0;
        falling += folder.rg70.values[i] > folder.rg10.values[i] ? 1 : 0;
    }
    return falling > rising;
}

/// Diameters scatter around their mean by less than a multiple of it: a smaller mean cannot be meant.
void check_diameters(const Folder& folder, Reader& reader) {
    constexpr double most_of_mean = 5.0;
    const std::vector<double>& means_cm = folder.mean_dbh_cm->values;
    constexpr double thinnest_median_cm = 1.5;  // as in lists of trees
    const double median_cm = median_within(means_cm, 251.0);
    if (median_cm > 0.0 && median_cm < thinnest_median_cm) {
        reader.problems().add(ExitCode::data, {.file = reader.path_of("dbhmean.asc").string()},
                              joined("a median of ", config::to_text(median_cm), ", which looks like metres"),
                              "diameters of trees in cm", "multiply dbhmean and dbhstd by 100");
    }
    std::size_t faults = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < means_cm.size(); ++i) {
        if (means_cm[i] > 0.0 && folder.dbh_deviation_cm->values[i] > most_of_mean * means_cm[i]) {
            first = faults++ == 0 ? i : first;
        }
    }
    if (faults > 0) {
        const config::Cell cell = folder.mean_dbh_cm->frame.cell_of(first);
        reader.problems().add(
            ExitCode::data, {.file = reader.path_of("dbhstd.asc").string()},
            joined(std::to_string(faults), " cells with a deviation above five times the mean, such as ",
                   config::to_text(folder.dbh_deviation_cm->values[first]), " cm around ",
                   config::to_text(means_cm[first]), " cm in row ", std::to_string(cell.row + 1), ", column ",
                   std::to_string(cell.column + 1)),
            "diameters of trees in cm in both rasters", "check whether dbhmean and dbhstd were swapped");
    }
}

void read_forest(Folder& folder, Reader& reader) {
    if (reader.has("treefile.txt")) {
        folder.trees = reader.tree_file("treefile.txt");
        for (const char* raster : {"nrtrees.asc", "dbhmean.asc", "dbhstd.asc"}) {
            if (reader.has(raster)) {
                folder.behind_trees.push_back(reader.path_of(raster).filename().string());
            }
        }
    } else if (reader.has("nrtrees.asc") || reader.has("dbhmean.asc")) {
        folder.stems_pha = reader.on(folder.dem, "nrtrees.asc", {.low = 0.0, .high = 10'000.0});
        folder.mean_dbh_cm = reader.on(folder.dem, "dbhmean.asc", {.low = 0.0, .high = 250.0});
        folder.dbh_deviation_cm = reader.on(folder.dem, "dbhstd.asc", {.low = 0.0, .high = 250.0});
        check_diameters(folder, reader);
    }
    if (reader.has("conif_percent.asc")) {
        folder.conifer_percent = reader.on(folder.dem, "conif_percent.asc", {.low = 0.0, .high = 100.0});
    }
}

/// Nets stand where net_number is above 0, each cell with the energy and height that it holds.
void read_rocky_nets(Folder& folder, Reader& reader) {
    if (!reader.has("net_number.asc")) {
        return;
    }
    folder.net_number = reader.on(folder.dem, "net_number.asc", {.low = 0.0, .high = 1e6}, true);
    folder.net_energy = reader.on(folder.dem, "net_energy.asc", {.low = 0.0, .high = 1e5}, false,
                                  "write kJ: divide joules by 1000");
    folder.net_height = reader.on(folder.dem, "net_height.asc", {.low = 0.0, .high = 50.0});
    std::size_t unknown = 0;
    for (std::size_t i = 0; i < folder.net_number->values.size(); ++i) {
        const bool is_whole = folder.net_energy->values[i] > 0.0 && folder.net_height->values[i] > 0.0;
        unknown += folder.net_number->values[i] > 0.0 && !is_whole ? 1 : 0;
    }
    if (unknown > 0 && reader.problems().empty()) {
        reader.problems().add(ExitCode::data, {.file = reader.path_of("net_energy.asc").string()},
                              joined(std::to_string(unknown), " cells of nets without energy or height"),
                              "net_energy in kJ and net_height in m above 0 wherever net_number is above 0");
    }
}

}  // namespace

Folder read_folder(const fs::path& path) {
    Reader reader{path};
    Folder folder;
    std::optional<Raster<double>> dem = reader.grid("dem.asc");
    reader.problems().throw_if_any();  // nothing can be compared without it
    folder.dem = std::move(*dem);
    if (reader.has("dem.prj")) {
        const FileBytes projection = open_file(reader.path_of("dem.prj"), {}, "a projection");
        folder.projection = std::string{projection.text()};
        reader.mark_read("dem.prj");
    }
    const NumberRange metres{.low = 0.0, .high = 20.0};
    const std::string in_metres = "write metres: divide centimetres by 100";
    const NumberRange roughness{.low = 0.0, .high = 100.0};
    folder.rock_density = reader.on(folder.dem, "rockdensity.asc", {.low = 0.0, .high = 5000.0});
    folder.d1 = reader.on(folder.dem, "d1.asc", metres, false, in_metres);
    folder.d2 = reader.on(folder.dem, "d2.asc", metres, false, in_metres);
    folder.d3 = reader.on(folder.dem, "d3.asc", metres, false, in_metres);
    folder.shape = reader.on(folder.dem, "blshape.asc", {.low = 0.0, .high = 4.0}, true);
    folder.soil_type = reader.on(folder.dem, "soiltype.asc", {.low = 0.0, .high = 7.0}, true);
    folder.rg70 = reader.on(folder.dem, "rg70.asc", roughness, false, in_metres);
    folder.rg20 = reader.on(folder.dem, "rg20.asc", roughness, false, in_metres);
    folder.rg10 = reader.on(folder.dem, "rg10.asc", roughness, false, in_metres);
    read_forest(folder, reader);
    read_rocky_nets(folder, reader);
    reader.problems().throw_if_any();
    check_cells(folder, reader);
    check_roughness(folder, reader);
    reader.problems().throw_if_any();
    folder.files = reader.files_read();
    folder.remarks = reader.remarks();
    if (roughness_looks_reversed(folder)) {
        folder.remarks.emplace_back(
            "Check rg70 and rg10: on most cells rg70, met in 70 % of the contacts, is higher than rg10, met "
            "in "
            "10 %. They look exchanged.");
    }
    folder.not_read = reader.others();
    std::erase_if(folder.not_read, [&](const std::string& name) {
        return std::find(folder.behind_trees.begin(), folder.behind_trees.end(), name) !=
               folder.behind_trees.end();
    });
    return folder;
}

}  // namespace coupling::rockyfor3d
