#pragma once

#include <CLI/CLI.hpp>

#include "modules/launch/sweep/sweep_options.h"

namespace citrine {

/// What may be said behind `citrine sweep`.
struct SweepCommand {
  SweepOptions options;

  explicit SweepCommand(CLI::App& app) {
    app.add_option("sweep", options.sweep, "A name in missions/sweeps/, or a sweep file")
        ->required()
        ->type_name("SWEEP");
    app.add_option("--jobs", options.jobs, "Missions at once on a host; default: one a processor")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    app.add_option("--hosts", options.hosts, "Fly over SSH, for example a,b,: where : is this machine")
        ->type_name("A,B");
    app.add_option("--seeds", options.seeds, "Other seeds than the sweep's")->type_name("1-10");
    app.add_option("--only", options.only, "Only where this is part of <world>/<variant>")->type_name("TEXT");
    app.add_option("--out", options.out, "Result folder; default results/sweeps/<name>")->type_name("DIR");
    app.add_option("--set", options.set, "Any key of the mission file, for all missions")
        ->type_name("SECTION.KEY=VALUE")
        ->allow_extra_args(false);
    app.add_flag("--again", options.again, "Fly anew what is finished");
    app.add_flag("--tables", options.tables, "Fly nothing, write the tables of what is there");
    app.add_flag("--list", options.list, "Only show the command of each mission");
  }
};

}  // namespace citrine
