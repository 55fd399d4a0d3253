#include "rocking/fields/container_types.hpp"
#include "rocking/studies/fragility/study.hpp"

namespace rocking {

const StructType& fields_of(const FragilityQuestion*) {
  using Type = FragilityQuestion;
  static const StructType fields{
      "FragilityQuestion",
      asked(field<&Type::events>("events",
                                 "What the probability is of: overturning (default), tilt > X psi, deg or rad (the "
                                 "peak; 1 psi is balance), slip > X m (the largest), displacement > X m (the slip at "
                                 "the end); an overturned block has every event; several between commas",
                                 the_only<ListType<std::vector<ResponseEvent>, 0, event_text_type>>()),
            {.names = "--event", .letter = "EVENT,EVENT", .kind = FlagKind::commas}),
      asked(field<&Type::years>("years",
                                "With --hazard: also the probabilities within these years, 1,50,475; one number is "
                                "also the time of the file's probabilities of exceedance, where it does not state it",
                                rule::positive),
            {.names = "--years", .letter = "T,T", .kind = FlagKind::commas, .needs = "--hazard"}),
      asked(field<&Type::incremental>("incremental",
                                      "Incremental dynamic analysis: quantiles of the peak tilt at each intensity, of "
                                      "each record and of all, and the number of resurrections"),
            {.names = "--ida", .kind = FlagKind::on}),
      asked(
          field<&Type::surface>(
              "surface", "Also the probability of a suite over two measures of intensity, such as pga_g,pgv_over_pga_s",
              Rule{.choices = surface_measure_names}),
          {.names = "--surface", .letter = "X,Y", .kind = FlagKind::commas}),
  };
  return fields;
}

const StructType& fields_of(const RunsQuestion*) {
  using Type = RunsQuestion;
  static const StructType fields{
      "RunsQuestion",
      inlined<&Type::question>(),
      asked(field<&Type::hazards>(
                "hazard",
                "Hazard curve (CSV: intensity, annual_rate or poe; its header names measure and kind; or of OpenQuake "
                "or the USGS): gives the mean annual rate; with --survived several, each a branch"),
            {.names = "--hazard", .letter = "FILE", .kind = FlagKind::repeated}),
      asked(field<&Type::survived>("survived",
                                   "With --hazard: the probability that the block, or all blocks of the sweep and the "
                                   "runs together, still stand after T years, and how likely each branch makes it",
                                   Rule{.above = 0.0, .most = 1e9}),
            {.names = "--survived", .letter = "T", .needs = "--hazard"}),
      asked(field<&Type::imt>("imt",
                              "With --hazard: the intensity measure, where the file has several or does not name it, "
                              "such as PGA or SA(0.5)"),
            {.names = "--imt", .letter = "MEASURE", .needs = "--hazard"}),
      asked(field<&Type::site>("site", "With --hazard: longitude and latitude of the site, where the file has several",
                               Rule{.least = -360.0, .most = 360.0}),
            {.names = "--site", .letter = "LON,LAT", .kind = FlagKind::commas, .needs = "--hazard"}),
      asked(field<&Type::statistic>(
                "statistic", "With --hazard: mean or quantile-0.84, or as the file says it, where it has several"),
            {.names = "--statistic", .letter = "NAME", .needs = "--hazard"}),
      asked(field<&Type::rare>(
                "rare_file",
                "Folder with the rare.json of `rocking rare` for lower intensities of the same block and motion, or "
                "suite of motions: the annual rate takes its probabilities below the levels with ten events"),
            {.names = "--rare", .letter = "DIR"}),
      asked(field<&Type::joint_hazard>("joint_hazard_file",
                                       "With --surface: rates of occurrence over both measures (CSV: X, Y, "
                                       "annual_rate, a line for each cell); gives the mean annual rate"),
            {.names = "--joint-hazard", .letter = "FILE", .needs = "--surface"}),
      asked(field<&Type::suggest>("suggest",
                                  "With --hazard: print only the intensities that would settle the rate of a suite, as "
                                  "a command `rocking resume DIR --levels X,X`"),
            {.names = "--suggest", .kind = FlagKind::on, .needs = "--hazard", .is_of_program = true}),
      asked(field<&Type::sheet>(
                "sheet", "With --hazard: the answer about a suite as one page of A4; FILE ends with .pdf or .html"),
            {.names = "--sheet",
             .letter = "FILE",
             .kind = FlagKind::new_file,
             .needs = "--hazard",
             .is_of_program = true}),
      asked(
          field<&Type::project>("project", "With --sheet: the project; without it the sheet has a line to write it on"),
          {.names = "--project", .letter = "TEXT", .needs = "--sheet", .is_of_program = true}),
      asked(field<&Type::date>("date", "With --sheet: the date, in any words; without it as the project"),
            {.names = "--date", .letter = "TEXT", .needs = "--sheet", .is_of_program = true}),
      asked(field<&Type::export_file>("export",
                                      "The fragility functions for other programs: FILE.xml is NRML of OpenQuake, "
                                      "FILE.csv CSV, or as --as says"),
            {.names = "--export", .letter = "FILE", .kind = FlagKind::new_file}),
      asked(field<&Type::export_as>("export_as", "Format of --export", Rule{.choices = export_format_names}),
            {.names = "--as", .letter = "FORMAT", .needs = "--export"}),
      asked(field<&Type::per_record>("per_record",
                                     "List the curve of each record of a suite in the table; the JSON always has them"),
            {.names = "--per-record", .kind = FlagKind::on, .is_of_program = true}),
  };
  return fields;
}

}  // namespace rocking
