#pragma once

/// \file
/// The interface of the library: read, run, look.
///
///     const rocking::Experiment experiment = rocking::read_experiment("mine.json");
///     const rocking::RunResult run = rocking::run(experiment, {.threads = 4});
///     for (const auto& [mode, probability] : run.result->conditions[0].modes) {
///       std::cout << rocking::name_of(mode) << ' ' << probability.estimate << '\n';
///     }
///
/// Stable between patch versions: what these headers declare in namespace rocking, and the structs that they return.
/// Whatever else is installed with them are their details.
#include "rocking/api/checks.hpp"
#include "rocking/api/experiment.hpp"
#include "rocking/api/infer.hpp"
#include "rocking/api/run.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/base/error.hpp"
