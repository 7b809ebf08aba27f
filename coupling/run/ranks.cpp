#include "coupling/run/ranks.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

#ifdef BANNWALD_MPI
#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/vector.hpp>
#endif

namespace coupling {
namespace {

using config::joined;

/// Processes that a launcher says it started; 1 without one.
long long launched_processes() {
    // Open MPI; MPICH, Intel MPI and others with its process manager; srun with PMIx, which leaves the number
    // to Slurm.
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
        const bool slurm_alone =
            name == std::string{"SLURM_STEP_NUM_TASKS"} && std::getenv("PMIX_RANK") == nullptr;
        if (const char* text = std::getenv(name); text != nullptr && !slurm_alone) {
            return config::parse_whole(text).value_or(1);
        }
    }
    return 1;
}

}  // namespace

#ifdef BANNWALD_MPI

namespace {

namespace mpi = boost::mpi;

constexpr int stop_tag = 1;
constexpr int progress_tag = 2;
constexpr int works = 2;

}  // namespace

class RankGroup::Joined {
public:
    Joined() : environment_{mpi::threading::serialized, false} {
        if (mpi::environment::thread_level() < mpi::threading::serialized) {
            config::fail(config::ExitCode::settings, {}, "an MPI that several threads cannot use",
                         "one with MPI_THREAD_SERIALIZED");
        }
        // All counters lie with the first rank; the others have a window of no length into it.
        const MPI_Aint bytes = first() ? works * static_cast<MPI_Aint>(sizeof(std::uint64_t)) : 0;
        MPI_Win_allocate(bytes, sizeof(std::uint64_t), MPI_INFO_NULL, world_, &counters_, &window_);
        if (first()) {
            std::fill_n(counters_, works, 0);
        }
        MPI_Barrier(world_);
        MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
        MPI_Comm machine = MPI_COMM_NULL;
        MPI_Comm_split_type(world_, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
        MPI_Comm_size(machine, &on_machine_);
        MPI_Comm_free(&machine);
    }
    ~Joined() {
        MPI_Win_unlock_all(window_);
        MPI_Win_free(&window_);
    }
    Joined(const Joined&) = delete;
    Joined& operator=(const Joined&) = delete;

    [[nodiscard]] int count() const { return world_.size(); }
    [[nodiscard]] bool first() const { return world_.rank() == 0; }
    [[nodiscard]] std::size_t number() const { return static_cast<std::size_t>(world_.rank()); }
    [[nodiscard]] int on_machine() const { return on_machine_; }

    std::uint64_t next(Work work) {
        const std::lock_guard lock{mutex_};
        const std::uint64_t one = 1;
        std::uint64_t taken = 0;
        MPI_Fetch_and_op(&one, &taken, MPI_UINT64_T, 0, static_cast<MPI_Aint>(work), MPI_SUM, window_);
        MPI_Win_flush(0, window_);
        return taken;
    }

    /// On the first rank while the others wait.
    void count_again() {
        const std::lock_guard lock{mutex_};
        const std::uint64_t none = 0;
        for (MPI_Aint work = 0; work < works; ++work) {
            MPI_Accumulate(&none, 1, MPI_UINT64_T, 0, work, 1, MPI_UINT64_T, MPI_REPLACE, window_);
        }
        MPI_Win_flush(0, window_);
    }

    std::uint64_t report(std::uint64_t steps) {
        const std::lock_guard lock{mutex_};
        if (!first() && steps > 0) {
            world_.send(0, progress_tag, steps);
        }
        // Looking for messages also lets others reach the counters: some networks need a hand of their owner.
        while (world_.iprobe(mpi::any_source, progress_tag)) {
            std::uint64_t more = 0;
            world_.recv(mpi::any_source, progress_tag, more);
            steps += more;
        }
        while (world_.iprobe(mpi::any_source, stop_tag)) {
            world_.recv(mpi::any_source, stop_tag);
            stopped_ = true;
        }
        return steps;
    }
    [[nodiscard]] bool stopped() const { return stopped_; }

    /// Whether all arrived without failure.
    bool met(const std::function<void()>& meanwhile) {
        const bool fine = least(world_.size(), meanwhile) == world_.size();
        failed_ = !fine;
        return fine;
    }

    std::vector<std::uint64_t> from_first(std::vector<std::uint64_t> list) {
        const std::lock_guard lock{mutex_};
        mpi::broadcast(world_, list, 0);
        return list;
    }

    std::vector<std::vector<double>> of_all(const std::vector<double>& own) {
        const std::lock_guard lock{mutex_};
        std::vector<std::vector<double>> lists;
        mpi::all_gather(world_, own, lists);
        return lists;
    }

    bool fail(bool by_itself) {
        if (!failed_) {
            failed_ = true;
            if (by_itself) {
                const std::lock_guard lock{mutex_};
                for (int rank = 0; rank < world_.size(); ++rank) {
                    if (rank != world_.rank()) {
                        world_.isend(rank, stop_tag);
                    }
                }
            }
            speaks_ = least(by_itself ? world_.rank() : world_.size(), {}) == world_.rank();
        }
        return speaks_;
    }

    int leave_with(int code) {
        if (!failed_ && !met({})) {
            code = 0;
        }
        report(0);  // takes messages that nobody waited for
        return -least(-code, {});
    }

private:
    /// The least number of any rank. RankGroup that wait sleep: the others need the machine.
    int least(int number, const std::function<void()>& meanwhile) {
        int result = number;
        MPI_Request request = MPI_REQUEST_NULL;
        {
            const std::lock_guard lock{mutex_};
            MPI_Iallreduce(&number, &result, 1, MPI_INT, MPI_MIN, world_, &request);
        }
        for (;;) {
            {
                const std::lock_guard lock{mutex_};
                int done = 0;
                MPI_Test(&request, &done, MPI_STATUS_IGNORE);
                if (done != 0) {
                    return result;
                }
            }
            if (meanwhile) {
                meanwhile();
            }
            std::this_thread::sleep_for(std::chrono::milliseconds{2});
        }
    }

    mpi::environment environment_;
    mpi::communicator world_;
    std::uint64_t* counters_ = nullptr;
    MPI_Win window_ = MPI_WIN_NULL;
    int on_machine_ = 1;
    std::mutex mutex_;  ///< MPI is called by one thread at a time
    std::atomic<bool> stopped_ = false;
    bool failed_ = false;
    bool speaks_ = false;
};

RankGroup::RankGroup() : joined_{launched_processes() > 1 ? std::make_unique<Joined>() : nullptr} {
    // A launcher of another MPI starts processes that do not find each other: each would do all the work, in
    // one folder.
    if (joined_ && joined_->count() != launched_processes()) {
        config::fail(config::ExitCode::settings, {},
                     joined(std::to_string(launched_processes()), " processes started, of which ",
                            std::to_string(joined_->count()), " found each other"),
                     joined("a launcher that belongs to ", mpi_in_words()));
    }
}

std::string mpi_in_words() {
    char text[MPI_MAX_LIBRARY_VERSION_STRING] = {};
    int length = 0;
    MPI_Get_library_version(text, &length);
    const std::string whole{text, static_cast<std::size_t>(length)};
    return whole.substr(0, whole.find_first_of(",\n"));
}

#else

/// Never made: a program without MPI has no other ranks.
class RankGroup::Joined {
public:
    [[nodiscard]] static int count() { return 1; }
    [[nodiscard]] static bool first() { return true; }
    [[nodiscard]] static std::size_t number() { return 0; }
    [[nodiscard]] static int on_machine() { return 1; }
    static std::uint64_t next(Work) { return 0; }
    static void count_again() {}
    static std::uint64_t report(std::uint64_t steps) { return steps; }
    [[nodiscard]] static bool stopped() { return false; }
    static bool met(const std::function<void()>&) { return true; }
    static std::vector<std::uint64_t> from_first(std::vector<std::uint64_t> list) { return list; }
    static std::vector<std::vector<double>> of_all(const std::vector<double>& own) { return {own}; }
    static bool fail(bool) { return true; }
    static int leave_with(int code) { return code; }
};

RankGroup::RankGroup() {
    if (const long long processes = launched_processes(); processes > 1) {
        config::fail(config::ExitCode::settings, {},
                     joined(std::to_string(processes), " processes started to share a run"),
                     "a program built with MPI (see `bannwald --version`), or one process");
    }
}

std::string mpi_in_words() {
    return "without MPI";
}

#endif

RankGroup::RankGroup(Alone) {}

RankGroup::~RankGroup() = default;

int RankGroup::count() const {
    return joined_ ? joined_->count() : 1;
}

bool RankGroup::first() const {
    return !joined_ || joined_->first();
}

int RankGroup::usual_threads() const {
    const int threads = omp_get_max_threads();
    // A launcher that binds ranks to processors has divided the machine already.
    const bool bound = omp_get_num_procs() < static_cast<int>(std::thread::hardware_concurrency());
    return joined_ && !bound ? std::max(1, threads / joined_->on_machine()) : threads;
}

void RankGroup::begin_work() {
    meet();
    if (joined_ && first()) {
        joined_->count_again();
    }
    for (std::atomic<std::uint64_t>& next : next_) {
        next = 0;
    }
    meet();
}

std::uint64_t RankGroup::next(Work work) {
    return joined_ ? joined_->next(work) : next_[static_cast<std::size_t>(work)]++;
}

std::uint64_t RankGroup::report(std::uint64_t steps) {
    return joined_ ? joined_->report(steps) : steps;
}

bool RankGroup::stopped() const {
    return joined_ && joined_->stopped();
}

void RankGroup::meet(const std::function<void()>& meanwhile) {
    if (joined_ && !joined_->met(meanwhile)) {
        throw FailedElsewhere{};
    }
}

std::vector<std::uint64_t> RankGroup::from_first(std::vector<std::uint64_t> list) {
    meet();
    return joined_ ? joined_->from_first(std::move(list)) : list;
}

std::vector<std::vector<double>> RankGroup::of_all(const std::vector<double>& own) {
    meet();
    return joined_ ? joined_->of_all(own) : std::vector<std::vector<double>>{own};
}

std::pair<std::size_t, std::size_t> RankGroup::share_of(std::size_t pieces) const {
    const auto ranks = static_cast<std::size_t>(count());
    const std::size_t number = joined_ ? joined_->number() : 0;
    return {pieces * number / ranks, pieces * (number + 1) / ranks};
}

bool RankGroup::fail(bool by_itself) {
    return joined_ ? joined_->fail(by_itself) : by_itself;
}

int RankGroup::leave_with(int code) {
    return joined_ ? joined_->leave_with(code) : code;
}

}  // namespace coupling
