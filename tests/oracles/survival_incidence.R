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

# Realisations that are observed window by window: the label of the fixed horizon or of a later window settles them, those
# without one are observed to the limit of their group (a run that was extended with another limit), and a share is
# stopped anywhere before. What appears in the last windows of an observation cannot be held: at risk only before them.
windowed <- function(seed, n, shares, horizon, window, limits, stopped, held) {
  set.seed(seed)
  mode <- sample(seq_along(shares), n, replace = TRUE, prob = shares)
  settling <- horizon + window * rgeom(n, c(0.3, 0.1, 0.15)[mode])
  observed <- rep_len(limits, n)
  early <- runif(n) < stopped
  observed[early] <- horizon + ceiling(runif(sum(early), 0, observed[early] - horizon))
  confirmation <- (held - 1) * window
  settled <- settling + confirmation <= observed
  event <- ifelse(settled, mode, 0)
  list(time = ifelse(settled, settling, observed - confirmation), event = event,
       settling = ifelse(settled, settling, -1), observed = observed)
}

of_windows <- function(name, held, data, events) {
  c(estimated(name, data, events),
    list(settling = data$settling, observed = data$observed, window = 50, held = held))
}

windowed_sets <- list(
  of_windows("300, limits of 300, 500 and 900", 2, windowed(5, 300, c(0.5, 0.3, 0.2), 100, 50, c(300, 500, 900), 0, 2), 3),
  of_windows("240, a fifth stopped, three windows held", 3, windowed(6, 240, c(0.6, 0.4), 100, 50, 700, 0.2, 3), 2),
  of_windows("40, half stopped, limits of 200 and 1000", 1, windowed(7, 40, c(0.2, 0.8), 100, 50, c(200, 1000), 0.5, 1), 2))
program <- paste("survival", packageVersion("survival"), "of", R.version.string)
cat(jsonlite::toJSON(list(program = program, sets = sets, windowed = windowed_sets), auto_unbox = TRUE, digits = NA), "\n")
