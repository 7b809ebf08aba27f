#include "coupling/assessments/decades/members/end_archive.hpp"

#include <concepts>
#include <type_traits>
#include <utility>

namespace coupling::decades {
namespace {

template <class T, class Of>
concept ConstOrNot = std::same_as<std::remove_const_t<T>, Of>;

// The fields of each struct that is more than bytes, in one order for writing and reading. Structured
// bindings must name them all.

template <ConstOrNot<config::Shape> T, class Visit>
void each_field(T& shape, const Visit& visit) {
    auto& [kind, parts] = shape;
    visit(kind, parts);
}

template <ConstOrNot<forest::TreatmentArea> T, class Visit>
void each_field(T& place, const Visit& visit) {
    auto& [polygons, management_units, from_slope_deg, to_slope_deg] = place;
    visit(polygons, management_units, from_slope_deg, to_slope_deg);
}

template <ConstOrNot<Area> T, class Visit>
void each_field(T& area, const Visit& visit) {
    auto& [number, order, place, area_ha, patches] = area;
    visit(number, order, place, area_ha, patches);
}

template <ConstOrNot<RegimeState::Cut> T, class Visit>
void each_field(T& cut, const Visit& visit) {
    auto& [intervention, year, area] = cut;
    visit(intervention, year, area);
}

template <ConstOrNot<RegimeState> T, class Visit>
void each_field(T& state, const Visit& visit) {
    auto& [cuts, visits, clearings] = state;
    visit(cuts, visits, clearings);
}

template <ConstOrNot<forest::SnagsAndLogs> T, class Visit>
void each_field(T& wood, const Visit& visit) {
    auto& [snags, logs] = wood;
    visit(snags, logs);
}

template <ConstOrNot<forest::StandImage> T, class Visit>
void each_field(T& stand, const Visit& visit) {
    auto& [year, trees, wounds, cohorts, patch_states, dead_wood, deaths, balance, earlier, next_id,
           stems_at_start, mass_at_start_kg, dead_wood_at_start_kg] = stand;
    visit(year, trees, wounds, cohorts, patch_states, dead_wood, deaths, balance, earlier, next_id,
          stems_at_start, mass_at_start_kg, dead_wood_at_start_kg);
}

template <ConstOrNot<MemberEnd> T, class Visit>
void each_field(T& end, const Visit& visit) {
    auto& [stand, regime] = end;
    visit(stand, regime);
}

class EndWriter {
public:
    explicit EndWriter(ByteWriter& out) : out_{out} {}
    template <Plain T>
    void one(const T& value) const {
        out_.value(value);
    }
    template <class T>
    void one(const std::vector<T>& list) const {
        if constexpr (Plain<T>) {
            out_.list(list);
        } else {
            out_.value(static_cast<std::uint64_t>(list.size()));
            for (const T& item : list) {
                one(item);
            }
        }
    }
    template <class T>
    requires(!Plain<T>) void one(const T& fields) const {
        each_field(fields, [this](const auto&... field) { (one(field), ...); });
    }

private:
    ByteWriter& out_;
};

class EndReader {
public:
    explicit EndReader(ByteReader& in) : in_{in} {}
    template <Plain T>
    void one(T& value) const {
        value = in_.value<T>();
    }
    template <class T>
    void one(std::vector<T>& list) const {
        if constexpr (Plain<T>) {
            list = in_.list<T>();
        } else {
            list.resize(in_.count_of(sizeof(std::uint64_t)));
            for (T& item : list) {
                one(item);
            }
        }
    }
    template <class T>
    requires(!Plain<T>) void one(T& fields) const {
        each_field(fields, [this](auto&... field) { (one(field), ...); });
    }

private:
    ByteReader& in_;
};

}  // namespace

void write(ByteWriter& out, const MemberEnd& end) {
    EndWriter{out}.one(end);
}

void read(ByteReader& in, MemberEnd& end) {
    EndReader{in}.one(end);
}

}  // namespace coupling::decades
