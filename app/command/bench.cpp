// `halfspace bench`: the project's benchmarks.
#include "app/bench/bench.hpp"

#include "app/command/command.hpp"

namespace hs::command {

Command add_bench(CLI::App& program, const Common& common) {
    auto options = std::make_shared<bench::BenchOptions>();
    CLI::App* app = program.add_subcommand(
        "bench", "Measure this program against its budgets, OSMesa and the machine's limits"
    );
    app->add_option("--only", options->only, "only results whose name begins like this");
    app->add_option("--data", options->data, "folder with stanford-bunny.obj");
    return {app, [options, &common] {
                options->json = common.json;
                options->quiet = common.quiet;
                return bench::run_bench(*options);
            }};
}

} // namespace hs::command
