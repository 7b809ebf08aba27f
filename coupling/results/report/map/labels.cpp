#include "coupling/results/report/map/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "coupling/results/tables/text_layout.hpp"
#include "coupling/results/text/element.hpp"

namespace coupling::report {
namespace {

using Box = LetteredBox;

constexpr double letter_width = 0.69;  ///< of the size of the type, which is bold: of the widest fonts
constexpr double above_base = 0.95;
constexpr double below_base = 0.35;

double width_in(const std::string& text, double lettering) {
    return letter_width * lettering * static_cast<double>(width_of(text));
}

/// The part of a segment inside a strip of x, as a box; empty (west > east) outside.
Box part_within(const DrawnPoint& a, const DrawnPoint& b, double west, double east) {
    const auto& [left, right] = a.x <= b.x ? std::pair{a, b} : std::pair{b, a};
    const double from = std::max(left.x, west);
    const double to = std::min(right.x, east);
    if (from > to) {
        return {1.0, 0.0, 0.0, 0.0};
    }
    const double rise = right.x > left.x ? (right.y - left.y) / (right.x - left.x) : 0.0;
    const double y1 = left.y + rise * (from - left.x);
    const double y2 = right.x > left.x ? left.y + rise * (to - left.x) : right.y;
    return {from, std::min(y1, y2), to, std::max(y1, y2)};
}

/// What a shape covers between two x: from its highest to its lowest point there.
Box covered(const NamedShape& shape, double west, double east) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Box all{west, far, east, -far};
    for (const auto& part : shape.parts) {
        for (std::size_t i = 0; i + 1 < part.size(); ++i) {
            const Box piece = part_within(part[i], part[i + 1], west, east);
            if (piece.west <= piece.east) {
                all.north = std::min(all.north, piece.north);
                all.south = std::max(all.south, piece.south);
            }
        }
    }
    return all;
}

bool touches(const NamedShape& shape, const Box& box) {
    for (const auto& part : shape.parts) {
        for (std::size_t i = 0; i + 1 < part.size(); ++i) {
            const Box piece = part_within(part[i], part[i + 1], box.west, box.east);
            if (piece.west <= piece.east && piece.north < box.south && box.north < piece.south) {
                return true;
            }
        }
    }
    return false;
}

struct Candidate {
    NamePlace place;
    Box box;
};

/// Places above and below a shape, the nearest and those in its middle first.
std::vector<Candidate> candidates(const NamedShape& shape, double lettering, double width, double height) {
    constexpr double gap = 0.45;
    const double half = 0.5 * width_in(shape.name, lettering);
    std::vector<Candidate> found;
    const std::vector<DrawnPoint>& line = shape.parts.front();
    const auto add = [&](double x, double base) {
        const Box box{x - half, base - above_base * lettering, x + half, base + below_base * lettering};
        if (box.north >= 0.0 && box.south <= height && box.west >= 0.0 && box.east <= width) {
            found.push_back({{x, base}, box});
        }
    };
    const auto by_x = [](const DrawnPoint& a, const DrawnPoint& b) { return a.x < b.x; };
    // A line of type further off there is room beyond distance marks.
    for (const double off : {gap, gap + 1.0}) {
        for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.05, 0.95}) {
            const auto& middle = line[static_cast<std::size_t>(share * static_cast<double>(line.size() - 1))];
            const double x =
                std::clamp(middle.x, std::min(half, 0.5 * width), std::max(width - half, 0.5 * width));
            const Box under = covered(shape, x - half, x + half);
            add(x, under.north - off * lettering);
            add(x, under.south + (off + 0.8) * lettering);
        }
    }
    // Beside a small shape.
    const Box all = covered(shape, -1e9, 1e9);
    const auto [west, east] = std::minmax_element(line.begin(), line.end(), by_x);
    for (const double base :
         {all.south + 0.6 * lettering, 0.5 * (all.north + all.south) + 0.3 * lettering, all.north}) {
        add(east->x + half + gap * lettering, base);
        add(west->x - half - gap * lettering, base);
    }
    // Of a shape at the rim a place inside, beside that of one of its corners on the sheet.
    for (const DrawnPoint& corner : line) {
        if (corner.x >= 0.0 && corner.x <= width && corner.y >= 0.0 && corner.y <= height) {
            add(std::clamp(corner.x, std::min(half, 0.5 * width), std::max(width - half, 0.5 * width)),
                std::clamp(corner.y - gap * lettering, std::min(above_base * lettering, 0.5 * height),
                           std::max(height - below_base * lettering, 0.5 * height)));
            break;
        }
    }
    return found;
}

}  // namespace

bool overlap(const LetteredBox& a, const LetteredBox& b) {
    return a.west < b.east && b.west < a.east && a.north < b.south && b.north < a.south;
}

LetteredBox box_of(const std::string& text, double x, double y, double lettering) {
    return {x, y - above_base * lettering, x + width_in(text, lettering), y + below_base * lettering};
}

std::vector<NamePlace> place_names(const std::vector<NamedShape>& shapes, std::vector<LetteredBox> taken,
                                   double lettering, double width, double height) {
    std::vector<NamePlace> places;
    for (const NamedShape& shape : shapes) {
        const std::vector<Candidate> possible = candidates(shape, lettering, width, height);
        const auto covers_no_text = [&](const Candidate& candidate) {
            return std::none_of(taken.begin(), taken.end(),
                                [&](const Box& box) { return overlap(box, candidate.box); });
        };
        const auto is_free = [&](const Candidate& candidate) {
            return covers_no_text(candidate) &&
                   std::none_of(shapes.begin(), shapes.end(),
                                [&](const NamedShape& other) { return touches(other, candidate.box); });
        };
        auto best = std::find_if(possible.begin(), possible.end(), is_free);
        const bool has_room = best != possible.end();
        if (!has_room) {
            best = std::find_if(possible.begin(), possible.end(), covers_no_text);
        }
        if (best == possible.end()) {
            // It would cover another name, or leave the sheet.
            const DrawnPoint& first = shape.parts.front().front();
            places.push_back({first.x, first.y, false, true});
            continue;
        }
        places.push_back(best->place);
        places.back().is_free = has_room;
        taken.push_back(best->box);
    }
    return places;
}

WrittenNames write_names(const std::vector<NamedShape>& shapes, std::vector<LetteredBox> taken,
                         double lettering, double width, double height) {
    constexpr std::size_t most_names_over_shapes = 10;
    const std::vector<NamePlace> places = place_names(shapes, std::move(taken), lettering, width, height);
    const Box sheet{0.0, 0.0, width, height};
    WrittenNames written;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (places[i].is_hidden || (!places[i].is_free && shapes.size() > most_names_over_shapes)) {
            written.left_out += touches(shapes[i], sheet) ? 1U : 0U;
            continue;
        }
        written.svg += svg_text(places[i].x, places[i].y, shapes[i].name,
                                {{"class", "name"}, {"text-anchor", "middle"}, {"font-size", lettering}});
    }
    return written;
}

}  // namespace coupling::report
