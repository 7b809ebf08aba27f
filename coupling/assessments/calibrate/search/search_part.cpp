#include "coupling/assessments/calibrate/search/search_part.hpp"

#include "coupling/results/disk/byte_archive.hpp"

namespace coupling::calibrate {
namespace {

void put(ByteWriter& out, const std::vector<Member>& members) {
    out.value(static_cast<std::uint64_t>(members.size()));
    for (const Member& member : members) {
        out.list(std::span<const double>{member.point.data(), static_cast<std::size_t>(member.point.size())});
        out.value(member.weight);
        out.list(member.distances);
        out.list(member.summary);
        out.list(member.figures);
    }
}

std::vector<Member> members_in(ByteReader& in) {
    constexpr std::size_t least_bytes = 40;  // a weight and the lengths of four lists
    std::vector<Member> members(in.count_of(least_bytes));
    for (Member& member : members) {
        const auto point = in.list<double>();
        member.point = Eigen::Map<const Point>(point.data(), static_cast<Eigen::Index>(point.size()));
        member.weight = in.value<double>();
        member.distances = in.list<double>();
        member.summary = in.list<double>();
        member.figures = in.list<double>();
    }
    return members;
}

void put(ByteWriter& out, const Ruled& ruled) {
    put(out, ruled.fallen);
    out.list(ruled.rounds);
    out.value(static_cast<std::uint64_t>(ruled.rulings.size()));
    for (const Ruling& ruling : ruled.rulings) {
        out.value(ruling.left);
        out.value(static_cast<std::uint64_t>(ruling.rules.size()));
        for (const Rule& rule : ruling.rules) {
            out.value(rule.figure);
            out.value(rule.emulator.form);
            out.list(rule.emulator.coefficients);
            out.value(rule.emulator.error);
            out.value(rule.emulator.explained);
            out.value(rule.observed);
            out.value(rule.deviation);
        }
    }
    out.list(ruled.scatter);
    out.value(ruled.beyond);
    out.value(ruled.beyond_kept);
    out.value(ruled.beyond_weight);
}

Ruled ruled_in(ByteReader& in) {
    constexpr std::size_t least_bytes_of_ruling = 16;
    constexpr std::size_t least_bytes_of_rule = 45;
    Ruled ruled;
    ruled.fallen = members_in(in);
    ruled.rounds = in.list<RuledRound>();
    ruled.rulings.resize(in.count_of(least_bytes_of_ruling));
    for (Ruling& ruling : ruled.rulings) {
        ruling.left = in.value<double>();
        ruling.rules.resize(in.count_of(least_bytes_of_rule));
        for (Rule& rule : ruling.rules) {
            rule.figure = in.value<std::uint32_t>();
            rule.emulator.form = in.value<Form>();
            rule.emulator.coefficients = in.list<double>();
            rule.emulator.error = in.value<double>();
            rule.emulator.explained = in.value<double>();
            rule.observed = in.value<double>();
            rule.deviation = in.value<double>();
        }
    }
    ruled.scatter = in.list<double>();
    ruled.beyond = in.value<std::uint64_t>();
    ruled.beyond_kept = in.value<std::uint64_t>();
    ruled.beyond_weight = in.value<double>();
    return ruled;
}

}  // namespace

void write_search(const std::filesystem::path& file, const SearchState& state) {
    const std::filesystem::path temporary = temporary_beside(file);
    ByteWriter out{temporary};
    out.list(state.waves);
    put(out, state.first);
    put(out, state.population);
    out.list(state.scale.medians);
    out.value(state.scale.at_90);
    out.value(state.scale.at_95);
    out.list(state.scale.sites);
    out.list(state.scale.of_sites);
    out.value(state.begun);
    put(out, state.accepted);
    out.value(state.is_done);
    out.value(state.end);
    put(out, state.ruled);
    close_and_rename(out, temporary, file);
}

SearchState read_search(const std::filesystem::path& file) {
    ByteReader in{file};
    SearchState state;
    state.waves = in.list<Wave>();
    state.first = members_in(in);
    state.population = members_in(in);
    state.scale.medians = in.list<double>();
    state.scale.at_90 = in.value<double>();
    state.scale.at_95 = in.value<double>();
    state.scale.sites = in.list<std::uint32_t>();
    state.scale.of_sites = in.list<double>();
    state.begun = in.value<Wave>();
    state.accepted = members_in(in);
    state.is_done = in.value<bool>();
    state.end = in.value<SearchEnd>();
    state.ruled = ruled_in(in);
    in.check_end();
    return state;
}

}  // namespace coupling::calibrate
