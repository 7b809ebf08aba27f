#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace coupling {

/// Another rank ended the run and says why: this one has nothing to say.
struct FailedElsewhere {};

/// The processes that a launcher (mpirun, srun) started to share one run; without a launcher this one alone.
///
/// Each process is a rank. All do the same steps; at `meet` and `from_first` they wait for each other, and
/// when one of them fails, all leave by an exception there. The first rank speaks and writes results. MPI is
/// used here and nowhere else, and only where a launcher started more than one process.
class RankGroup {
public:
    /// Work that ranks share piece by piece; each kind has a counter of its own.
    enum class Work : std::uint8_t { bare_slope, members };

    /// Joins the other ranks. Throws config::InputError (settings) if there are some and the program was
    /// built without MPI, or with one that does not find them (another launcher's).
    RankGroup();
    struct Alone {};
    /// One process for itself, whatever started it.
    explicit RankGroup(Alone);
    ~RankGroup();
    RankGroup(const RankGroup&) = delete;
    RankGroup& operator=(const RankGroup&) = delete;

    [[nodiscard]] int count() const;
    [[nodiscard]] bool first() const;
    /// Threads for this rank where the user asks for none in particular: its share of the machine.
    [[nodiscard]] int usual_threads() const;

    /// Work begins that ranks share: all wait for each other, and pieces count from 0 again. A process may do
    /// one run after the other. Throws as meet.
    void begin_work();
    /// Number of the next piece that no rank has taken, from 0. From any thread.
    std::uint64_t next(Work work);
    /// Tells the first rank how many steps of progress were made. On the first rank: returns these and what
    /// others reported since the last call. From any thread.
    std::uint64_t report(std::uint64_t steps);
    /// Whether another rank has failed, as far as `report` has heard.
    [[nodiscard]] bool stopped() const;

    /// Waits until all ranks are here, calling `meanwhile` again and again. Throws FailedElsewhere if one of
    /// them has failed.
    void meet(const std::function<void()>& meanwhile = {});
    /// The list of the first rank on all of them. Throws as meet.
    std::vector<std::uint64_t> from_first(std::vector<std::uint64_t> list);

    /// The lists of all ranks, in their order, on each of them. Throws as meet.
    std::vector<std::vector<double>> of_all(const std::vector<double>& own);
    /// The share of this rank in `count` pieces that follow one another: its first piece and the one after
    /// its last.
    [[nodiscard]] std::pair<std::size_t, std::size_t> share_of(std::size_t count) const;

    /// For a rank that leaves by an exception: ends the work of the others and waits for them. Whether this
    /// rank shall say why: the first of those that failed by themselves. Further calls only repeat it.
    bool fail(bool by_itself);
    /// The end of all ranks: returns the code of the one that spoke, or 0.
    int leave_with(int code);

private:
    class Joined;
    std::unique_ptr<Joined> joined_;                    ///< with other ranks only
    std::array<std::atomic<std::uint64_t>, 2> next_{};  ///< alone
};

/// The MPI that the program was built with, or "without MPI".
std::string mpi_in_words();

}  // namespace coupling
