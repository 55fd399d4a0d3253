# Reference values of the law of a suite of records: made-up suites, fitted by lme4::glmer with a probit link, a random
# intercept of each record and adaptive Gauss-Hermite quadrature with 25 nodes.
#
#     Rscript tests/oracles/lme4_suite.R > tests/oracles/lme4_suite.json
#
# Debian: r-base-core, r-cran-lme4, r-cran-jsonlite.

suppressMessages(library(lme4))

made_up <- function(seed, records, levels, trials, median, between, within) {
  set.seed(seed)
  rows <- expand.grid(level = levels, record = seq_len(records))
  capacity <- log(median) + between * rnorm(records)
  p <- pnorm((log(rows$level) - capacity[rows$record]) / within)
  rows$trials <- trials
  rows$happened <- rbinom(nrow(rows), trials, p)
  rows
}

fitted <- function(name, rows) {
  rows$u <- log(rows$level)
  rows$record <- factor(rows$record)
  model <- glmer(cbind(happened, trials - happened) ~ u + (1 | record), data = rows,
                 family = binomial(link = "probit"), nAGQ = 25,
                 control = glmerControl(optimizer = "bobyqa", tolPwrss = 1e-12,
                                        optCtrl = list(rhobeg = 1e-2, rhoend = 1e-10, maxfun = 100000)))
  a <- unname(fixef(model)[1]); b <- unname(fixef(model)[2]); t <- unname(getME(model, "theta"))
  pooled <- glm(cbind(happened, trials - happened) ~ u, data = rows, family = binomial(link = "probit"),
                control = glm.control(epsilon = 1e-14, maxit = 100))
  list(name = name,
       record = as.integer(rows$record), intensity = rows$level, trials = rows$trials, happened = rows$happened,
       median = exp(-a / b), between_records = t / b, within_record = 1 / b,
       pooled_median = exp(-unname(coef(pooled)[1] / coef(pooled)[2])),
       pooled_dispersion = 1 / unname(coef(pooled)[2]))
}

suites <- list(
  fitted("20 records, 5 levels, 40 trials", made_up(1, 20, c(0.6, 0.8, 1.0, 1.3, 1.7), 40, 1.0, 0.4, 0.3)),
  fitted("8 records, 7 levels, 100 trials", made_up(2, 8, seq(0.2, 0.8, 0.1), 100, 0.45, 0.25, 0.35)),
  fitted("30 records, 6 levels, 1 trial", made_up(3, 30, c(0.5, 0.7, 1.0, 1.4, 2.0, 2.8), 1, 1.1, 0.5, 0.4)),
  fitted("12 records, 4 levels, 200 trials", made_up(4, 12, c(1, 2, 3, 4), 200, 2.5, 0.6, 0.5)),
  fitted("15 records, 5 levels, 20 trials, hardly any scatter between them",
         made_up(5, 15, c(0.6, 0.8, 1.0, 1.3, 1.7), 20, 1.0, 0.05, 0.4)))
# Scatter within a record far below that between them: the likelihood of a record is then nearly flat between two levels
# and falls steeply beyond, which nodes scaled by the curvature at the mode follow badly. Below about 0.03 glmer often
# fails.
fine <- c(0.6, 0.8, 1.0, 1.3, 1.7)
steep <- list(
  fitted("20 records, 7 levels, 100 trials, 0.05 within", made_up(11, 20, seq(0.4, 1.6, 0.2), 100, 1.0, 0.4, 0.05)),
  fitted("12 records, 9 levels, 200 trials, 0.04 within", made_up(12, 12, seq(0.3, 1.1, 0.1), 200, 0.6, 0.3, 0.04)),
  fitted("40 records, 5 levels, 10 trials, 0.04 within", made_up(13, 40, fine, 10, 1.0, 0.5, 0.04)),
  fitted("40 records, 5 levels, 10 trials, 0.03 within", made_up(12, 40, fine, 10, 1.0, 0.5, 0.03)))
cat(jsonlite::toJSON(list(program = paste("lme4", packageVersion("lme4"), "of", R.version.string), suites = suites,
                          steep = steep),
                     digits = NA, auto_unbox = TRUE, pretty = FALSE), "\n")
