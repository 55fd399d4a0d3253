# Reference values of cumulative incidences: made-up settling times with competing events and censoring, estimated by
# survival::survfit for multi-state data (Aalen and Johansen), with the standard errors of the infinitesimal jackknife.
#
#     Rscript tests/oracles/survival_incidence.R > tests/oracles/survival_incidence.json
#
# Debian: r-base-core, r-cran-survival, r-cran-jsonlite.

library(survival)

made_up <- function(seed, n, rates, longest, early) {
  set.seed(seed)
  ends <- sapply(rates, function(rate) ceiling(rexp(n, rate)))
  time <- apply(ends, 1, min)
  event <- apply(ends, 1, which.min)
  # The last censoring is that of the horizon; a share `early` is censored before it.
  censoring <- ifelse(runif(n) < early, ceiling(runif(n, 0, longest)), longest)
  event[time > censoring] <- 0
  list(time = pmin(time, censoring), event = event)
}

estimated <- function(name, data, events) {
  fit <- survfit(Surv(data$time, factor(data$event, 0:events)) ~ 1)
  list(name = name, time = data$time, event = data$event, events = events,
       curves = lapply(seq_len(events), function(k)
         list(times = fit$time, estimate = fit$pstate[, k + 1], standard_error = fit$std.err[, k + 1])))
}

sets <- list(
  estimated("200, two events, one horizon", made_up(1, 200, c(0.01, 0.004), 150, 0), 2),
  estimated("60, three events, half censored early", made_up(2, 60, c(0.01, 0.02, 0.005), 80, 0.5), 3),
  estimated("12, two events, heavy censoring", made_up(3, 12, c(0.01, 0.01), 40, 0.8), 2),
  estimated("500, one event", made_up(4, 500, 0.02, 100, 0.3), 1))
program <- paste("survival", packageVersion("survival"), "of", R.version.string)
cat(jsonlite::toJSON(list(program = program, sets = sets), auto_unbox = TRUE, digits = NA), "\n")
