#include "rockfall/terrain/edges.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace rockfall {
namespace {

/// A side of a face under the ends of its edge, the smaller one first.
struct Entry {
    std::uint32_t low;
    std::uint32_t high;
    TinSide side;
    bool rises;  ///< runs from the smaller end to the larger one
};

std::vector<Entry> sorted_sides(std::span<const TinFace> faces) {
    std::vector<Entry> entries;
    entries.reserve(3 * faces.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        for (std::uint32_t side = 0; side < 3; ++side) {
            const std::uint32_t from = faces[f].corners[side];
            const std::uint32_t to = faces[f].corners[(side + 1) % 3];
            entries.push_back({std::min(from, to), std::max(from, to), {f, side}, from < to});
        }
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.low, a.high, a.side.face) < std::tie(b.low, b.high, b.side.face);
    });
    return entries;
}

}  // namespace

TinEdges edges_of(std::span<const TinFace> faces) {
    TinEdges edges;
    edges.neighbours.assign(faces.size(), {no_triangle, no_triangle, no_triangle});
    const std::vector<Entry> entries = sorted_sides(faces);
    for (std::size_t begin = 0; begin < entries.size();) {
        std::size_t end = begin + 1;
        while (end < entries.size() && entries[end].low == entries[begin].low &&
               entries[end].high == entries[begin].high) {
            ++end;
        }
        const Entry& first = entries[begin];
        if (end - begin == 1) {
            edges.borders.push_back(first.side);
        } else if (end - begin > 2) {
            edges.crowded.push_back(first.side);
        } else if (const Entry& second = entries[begin + 1]; first.rises == second.rises) {
            edges.disagreeing.push_back({first.side, second.side});
        } else {
            edges.neighbours[first.side.face][first.side.side] = second.side.face;
            edges.neighbours[second.side.face][second.side.side] = first.side.face;
        }
        begin = end;
    }
    return edges;
}

std::vector<std::uint32_t> flipped_faces(const TinEdges& edges) {
    if (edges.disagreeing.empty()) {
        return {};
    }
    std::vector<std::vector<std::uint32_t>> against(edges.neighbours.size());
    for (const auto& [one, other] : edges.disagreeing) {
        against[one.face].push_back(other.face);
        against[other.face].push_back(one.face);
    }
    enum class Sense : std::uint8_t { unknown, as_first, other };
    std::vector<Sense> sense(edges.neighbours.size(), Sense::unknown);
    std::vector<std::uint32_t> flipped;
    for (std::uint32_t seed = 0; seed < sense.size(); ++seed) {
        if (sense[seed] != Sense::unknown) {
            continue;
        }
        std::vector<std::uint32_t> part{seed};  // grows while it is walked
        sense[seed] = Sense::as_first;
        const auto take = [&](std::uint32_t face, Sense its) {
            if (face != no_triangle && sense[face] == Sense::unknown) {
                sense[face] = its;
                part.push_back(face);
            }
        };
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Sense here = sense[part[i]];
            for (const std::uint32_t next : edges.neighbours[part[i]]) {
                take(next, here);
            }
            for (const std::uint32_t next : against[part[i]]) {
                take(next, here == Sense::other ? Sense::as_first : Sense::other);
            }
        }
        const auto others = std::count_if(part.begin(), part.end(),
                                          [&](std::uint32_t face) { return sense[face] == Sense::other; });
        const Sense rare =
            2 * others <= static_cast<std::ptrdiff_t>(part.size()) ? Sense::other : Sense::as_first;
        std::copy_if(part.begin(), part.end(), std::back_inserter(flipped),
                     [&](std::uint32_t face) { return sense[face] == rare; });
    }
    for (const auto& [one, other] : edges.disagreeing) {
        if (sense[one.face] == sense[other.face]) {
            flipped.push_back(other.face);
        }
    }
    std::sort(flipped.begin(), flipped.end());
    flipped.erase(std::unique(flipped.begin(), flipped.end()), flipped.end());
    return flipped;
}

std::vector<std::uint32_t> parts_of(const TinEdges& edges) {
    std::vector<std::uint32_t> part(edges.neighbours.size(), no_triangle);
    std::uint32_t parts = 0;
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t seed = 0; seed < part.size(); ++seed) {
        if (part[seed] != no_triangle) {
            continue;
        }
        part[seed] = parts;
        waiting.assign(1, seed);
        while (!waiting.empty()) {
            const std::uint32_t face = waiting.back();
            waiting.pop_back();
            for (const std::uint32_t next : edges.neighbours[face]) {
                if (next != no_triangle && part[next] == no_triangle) {
                    part[next] = parts;
                    waiting.push_back(next);
                }
            }
        }
        ++parts;
    }
    return part;
}

}  // namespace rockfall
