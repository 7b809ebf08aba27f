#include "coupling/program/commands.hpp"

namespace coupling {

std::vector<Command> commands_of_the_program() {
    return {init_command(),           check_command(),     run_command(),     merge_command(),
            vary_command(),           calibrate_command(), compare_command(), at_command(),
            collapse_command(),       pack_command(),      verify_command(),  net_command(),
            stopping_table_command(), models_command(),    info_command(),    completion_command()};
}

}  // namespace coupling
