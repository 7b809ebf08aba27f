#include "coupling/inputs/scenario/block_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/words_of_list.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"
#include "coupling/inputs/tables/prepare.hpp"
#include "rockfall/motion/models.hpp"
#include "rockfall/parameters.hpp"
#include "rockfall/solids/shapes.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;
using Eigen::Vector3d;
using rockfall::BlockShape;

constexpr double longest_side_m = 50.0;
constexpr std::size_t most_points = 10'000;

/// Points of a mesh whose faces each have corners of their own (STL) become shared ones.
std::vector<Vector3d> shared_points(const meshes::MeshFile& mesh,
                                    std::vector<std::vector<std::uint32_t>>& faces) {
    std::map<std::array<double, 3>, std::uint32_t> numbers;
    std::vector<Vector3d> points;
    const auto number_of = [&](const Vector3d& point) {
        const auto [found, is_new] =
            numbers.try_emplace({point.x(), point.y(), point.z()}, static_cast<std::uint32_t>(points.size()));
        if (is_new) {
            points.push_back(point);
        }
        return found->second;
    };
    for (const auto& face : mesh.faces) {
        std::vector<std::uint32_t> corners;
        for (const std::uint32_t corner : face) {
            corners.push_back(number_of(mesh.points_m[corner]));
        }
        faces.push_back(std::move(corners));
    }
    return points;
}

std::vector<Vector3d> points_of_table(std::string_view bytes, const std::string& file) {
    config::Table table = config::Table::read(bytes, file, config::FirstColumn::may_lack_name);
    std::vector<std::string> notes;  // a hull has its three columns and nothing to fill in
    tables::add_remarks(tables::prepare(table, "points", false), notes);
    config::Problems problems;
    table.require({"x_m", "y_m", "z_m"}, problems);
    problems.throw_if_any();
    std::vector<Vector3d> points;
    constexpr config::NumberRange range{.low = -1000.0, .high = 1000.0};
    for (std::size_t row = 0; row < table.rows() && points.size() <= most_points; ++row) {
        points.emplace_back(table.number(row, "x_m", range, problems).value_or(0.0),
                            table.number(row, "y_m", range, problems).value_or(0.0),
                            table.number(row, "z_m", range, problems).value_or(0.0));
    }
    problems.throw_if_any();
    return points;
}

bool is_mesh(std::string_view bytes, const std::string& file) {
    const auto format = bytes.empty() ? meshes::MeshFormat::points : meshes::format_of(bytes, file);
    return format == meshes::MeshFormat::ply || format == meshes::MeshFormat::stl;
}

/// The attitude that nine or four numbers say; a problem where they are no rotation.
std::optional<Eigen::Quaterniond> attitude_of(const std::vector<double>& numbers, const config::Place& place,
                                              config::Problems& problems) {
    constexpr double rounding = 1e-6;
    if (numbers.size() == 4) {
        const Eigen::Quaterniond q{numbers[0], numbers[1], numbers[2], numbers[3]};
        if (std::abs(q.norm() - 1.0) <= rounding) {
            return q.normalized();
        }
        problems.add(ExitCode::settings, place, joined("an attitude of length ", config::to_text(q.norm())),
                     "a rotation: a quaternion (w, x, y, z) of length 1",
                     "divide its numbers by that length");
        return std::nullopt;
    }
    if (numbers.size() == 9) {
        Eigen::Matrix3d m;
        for (int k = 0; k < 9; ++k) {
            m(k / 3, k % 3) = numbers[static_cast<std::size_t>(k)];
        }
        if ((m * m.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= rounding &&
            m.determinant() > 0.0) {
            return Eigen::Quaterniond{m}.normalized();
        }
        problems.add(
            ExitCode::settings, place,
            joined("an attitude that is no rotation (determinant ", config::to_text(m.determinant()), ")"),
            "a matrix whose rows are unit vectors at right angles, determinant 1",
            "write its nine numbers row by row, or leave it out: then attitudes are at random");
        return std::nullopt;
    }
    problems.add(ExitCode::settings, place,
                 joined("an attitude of ", std::to_string(numbers.size()), " numbers"),
                 "four (quaternion w, x, y, z) or nine (rotation matrix, row by row)");
    return std::nullopt;
}

/// Three sides above 0, or a problem.
std::optional<Vector3d> sides_of(const std::vector<double>& numbers, const config::Place& place,
                                 config::Problems& problems) {
    const bool are_positive = std::all_of(numbers.begin(), numbers.end(),
                                          [](double side) { return side > 0.0 && side <= longest_side_m; });
    if (numbers.size() == 3 && are_positive) {
        return Vector3d{numbers[0], numbers[1], numbers[2]};
    }
    std::string found;
    for (const double side : numbers) {
        found = joined(found, found.empty() ? "" : ", ", config::to_text(side));
    }
    problems.add(ExitCode::settings, place, joined("sides ", found.empty() ? "of nothing" : found),
                 joined("three sides above 0 and at most ", config::to_text(longest_side_m)),
                 "write length, width and thickness, such as 1, 0.8, 0.5");
    return std::nullopt;
}

class ShapeReader {
public:
    ShapeReader(const ShapeSettings& settings, const PlaceOfSetting& place,
                const std::function<std::filesystem::path(const std::string&)>& resolve,
                config::Problems& problems)
        : settings_{settings}, place_{place}, resolve_{resolve}, problems_{problems} {}

    std::optional<BlockShape> read(const std::string& name) {
        BlockShape shape;
        shape.name = name;
        if (name == "hull") {
            shape.hull = hull_of_file();
            shape.own_size = settings_.keeps_size;
            return shape.hull ? std::optional{shape} : std::nullopt;
        }
        const bool takes_sides = name == "box" || name == "rounded" || name == "ellipsoid";
        if (takes_sides && (!settings_.sides.empty() || !settings_.sides_m.empty())) {
            return with_sides(std::move(shape));
        }
        if (name == "box" || name == "rounded") {
            problems_.add(ExitCode::settings, place_("shape"), joined("a ", name, " block without sides"),
                          "release.sides (relative) or release.sides_m", "or write cube, plate or column");
            return std::nullopt;
        }
        const std::vector<std::string> names = rockfall::named_shapes();
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            std::vector<std::string> known = names;
            known.insert(known.end(), {"box", "rounded", "hull"});
            const std::string nearest = config::nearest_word(name, known);
            std::string list;
            for (const std::string& word : known) {
                list = joined(list, list.empty() ? "" : ", ", word);
            }
            problems_.add(ExitCode::settings, place_("shape"), joined("shape ", config::in_quotes(name)),
                          nearest.empty() ? joined("one of ", list) : config::in_quotes(nearest));
            return std::nullopt;
        }
        shape.hull = rockfall::hull_of_shape(name);
        return shape;
    }

private:
    std::optional<BlockShape> with_sides(BlockShape shape) {
        const bool absolute = !settings_.sides_m.empty();
        const auto sides = sides_of(absolute ? settings_.sides_m : settings_.sides,
                                    place_(absolute ? "sides_m" : "sides"), problems_);
        if (!sides) {
            return std::nullopt;
        }
        constexpr double thinnest = 1e-3;
        if (sides->minCoeff() < thinnest * sides->maxCoeff()) {
            problems_.add(ExitCode::settings, place_(absolute ? "sides_m" : "sides"),
                          joined("a block ", config::to_text(sides->maxCoeff() / sides->minCoeff()),
                                 " times as long as thick"),
                          "a thickness of at least a thousandth of the length");
            return std::nullopt;
        }
        constexpr int divisions = 2;
        shape.hull = shape.name == "box" ? rockfall::solids::box(*sides)
                     : shape.name == "rounded"
                         ? rockfall::solids::chamfered_box(*sides, rockfall::rounded_cut)
                         : rockfall::solids::ellipsoid(*sides, divisions);
        shape.own_size = absolute;
        return shape;
    }

    std::optional<rockfall::solids::Hull> hull_of_file() {
        if (settings_.file.empty()) {
            problems_.add(ExitCode::settings, place_("shape"), "shape hull without a file",
                          "release.shape_file: points x_m, y_m, z_m as CSV, or a PLY or STL mesh");
            return std::nullopt;
        }
        try {
            const std::filesystem::path file = resolve_(settings_.file);
            const FileBytes bytes =
                open_file(file, place_("shape_file"), "a hull: points as CSV, PLY or STL");
            return read_hull(bytes.text(), file.string());
        } catch (const config::InputError& error) {
            problems_.add(error);
            return std::nullopt;
        }
    }

    const ShapeSettings& settings_;
    const PlaceOfSetting& place_;
    const std::function<std::filesystem::path(const std::string&)>& resolve_;
    config::Problems& problems_;
};

}  // namespace

void declare_shapes(config::Options& options, ShapeSettings& settings) {
    options.text(
        "release.shape", settings.shape,
        {.meaning =
             "shapes of blocks, in a list; models of spheres take only how long they are: sphere, cube, "
             "plate, column, box, rounded, ellipsoid, "
             "octahedron, equant, hull, or a form class (compact to very-elongate)",
         .source = "Sneed & Folk 1958; sides: choice"});
    options.numbers("release.shape_shares", settings.shares,
                    {.low = 0.0,
                     .high = 1e6,
                     .meaning = "shares of the rocks, one for each shape; none: equal",
                     .source = "choice"});
    options.numbers(
        "release.sides", settings.sides,
        {.meaning = "three sides of box, rounded or ellipsoid, relative; the diameter gives the volume",
         .source = "choice"});
    options.numbers("release.sides_m", settings.sides_m,
                    {.unit = "m",
                     .meaning = "three sides of box, rounded or ellipsoid as they are; replace the diameter",
                     .source = "choice"});
    options.number("release.sides_scatter", settings.sides_scatter,
                   {.unit = "-",
                    .low = 0.0,
                    .high = 0.9,
                    .meaning = "each side is drawn within this share of itself, either way",
                    .source = "choice"});
    options.file("release.shape_file", settings.file,
                 {.meaning = "hull: CSV of points x_m, y_m, z_m, or a closed convex PLY or STL mesh"});
    options.flag(
        "release.shape_keeps_size", settings.keeps_size,
        {.meaning = "the hull is as large as in its file; no: as the diameter says", .source = "choice"});
    options.numbers("release.attitude", settings.attitude,
                    {.meaning = "attitude at release: quaternion w, x, y, z or rotation matrix, row by row; "
                                "none: at random",
                     .source = "choice"});
}

rockfall::solids::Hull read_hull(std::string_view bytes, const std::string& file) {
    try {
        if (is_mesh(bytes, file)) {
            const meshes::MeshFile mesh = meshes::read_mesh_file(bytes, file);
            if (mesh.faces.empty()) {
                return rockfall::solids::convex_hull(mesh.points_m);
            }
            std::vector<std::vector<std::uint32_t>> faces;
            const std::vector<Vector3d> points = shared_points(mesh, faces);
            if (points.size() > most_points) {
                config::fail(ExitCode::data, {file}, joined(std::to_string(points.size()), " points"),
                             joined("a hull of at most ", std::to_string(most_points)));
            }
            return rockfall::solids::hull_of_faces(points, faces);
        }
        const std::vector<Vector3d> points = points_of_table(bytes, file);
        if (points.size() > most_points) {
            config::fail(ExitCode::data, {file}, joined(std::to_string(points.size()), " points or more"),
                         joined("a hull of at most ", std::to_string(most_points)));
        }
        return rockfall::solids::convex_hull(points);
    } catch (const rockfall::solids::NoSolid& fault) {
        config::fail(
            ExitCode::data, {file}, fault.what(),
            "a solid convex block: four points or more that do not lie in one plane, faces outwards");
    }
}

std::shared_ptr<const rockfall::ShapeLaw> shape_law(
    const ShapeSettings& settings, const PlaceOfSetting& place,
    const std::function<std::filesystem::path(const std::string&)>& resolve, config::Problems& problems) {
    config::Problems found;
    ShapeReader reader{settings, place, resolve, found};
    const std::vector<std::string> names = config::words_of_list(settings.shape);
    std::vector<BlockShape> shapes;
    for (const std::string& name : names) {
        if (auto shape = reader.read(name)) {
            shapes.push_back(std::move(*shape));
        }
    }
    std::optional<Eigen::Quaterniond> attitude;
    if (!settings.attitude.empty()) {
        attitude = attitude_of(settings.attitude, place("attitude"), found);
    }
    if (!settings.shares.empty() && settings.shares.size() != names.size()) {
        found.add(ExitCode::settings, place("shape_shares"),
                  joined(std::to_string(settings.shares.size()), " shares for ", std::to_string(names.size()),
                         names.size() == 1 ? " shape" : " shapes"),
                  "one share for each shape");
    } else if (std::any_of(settings.shares.begin(), settings.shares.end(),
                           [](double s) { return !(s > 0.0); })) {
        found.add(ExitCode::settings, place("shape_shares"), "a share of 0 or less", "shares above 0",
                  "leave out the shape that no rock has");
    }
    if (!found.list().empty()) {
        for (const auto& problem : found.list()) {
            problems.add(problem);
        }
        return nullptr;
    }
    for (std::size_t i = 0; i < settings.shares.size(); ++i) {
        shapes[i].share = settings.shares[i];
    }
    const bool only_spheres = std::all_of(shapes.begin(), shapes.end(),
                                          [](const BlockShape& shape) { return !shape.hull.has_value(); });
    if (only_spheres) {
        return nullptr;
    }
    return std::make_shared<const rockfall::ShapeLaw>(std::move(shapes), settings.sides_scatter, attitude);
}

bool rocks_have_shapes(const rockfall::Parameters& rockfall) {
    return rockfall::description_of(rockfall.fall.motion.model).has_shape;
}

}  // namespace coupling
