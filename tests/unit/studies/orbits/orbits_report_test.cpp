// Periodic orbits in files: what contradicts itself is refused.

#include <string>

#include <gmock/gmock.h>

#include "rocking/base/error.hpp"
#include "rocking/studies/orbits/study.hpp"

namespace {

using namespace rocking;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Orbit orbit_of_two_periods() {
  Orbit orbit;
  orbit.period = 2;
  orbit.points.resize(2);
  return orbit;
}

/// One condition with an orbit, on a branch with a bifurcation from which a curve was followed.
Json orbits_example() {
  const Orbit orbit = orbit_of_two_periods();
  OrbitsReport report;
  report.input.sha256 = std::string(64, '0');
  OrbitsOfCondition& condition = report.study.conditions.emplace_back();
  condition.parameters = {{.pointer = "/restitution", .value = 0.5}};
  condition.orbits = {orbit};
  condition.orbits[0].mirror = 0;
  condition.run_on = 0;
  report.study.longest = 2;
  FoundBranches& branches = report.study.branches.emplace();
  branches.pointer = "/restitution";
  branches.most_points = 2;
  branches.study.branches = {{.period = 2, .points = {{.value = 0.5, .orbit = orbit}}, .from = 0}};
  branches.study.bifurcations = {{.error = 1e-9, .orbit = orbit}};
  return Json::parse(orbits_document().text(report));
}

std::string refusal(const Json& json) {
  try {
    static_cast<void>(orbits_document().read(json));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(OrbitsReport, IsReadWhereItsPlacesLeadToWhatTheyName) {
  const Json good = orbits_example();
  EXPECT_THAT(refusal(good), IsEmpty());
  for (const char* place :
       {"/conditions/0/run/orbit", "/conditions/0/orbits/0/mirror", "/branches/0/from", "/bifurcations/0/branch"}) {
    Json bad = good;
    ASSERT_EQ(bad.at(Json::json_pointer(place)), 0) << place;
    bad[Json::json_pointer(place)] = 1;
    EXPECT_THAT(refusal(bad), HasSubstr(std::string(place) + " = 1: leads to none of the 1 there"));
  }
}

TEST(OrbitsReport, RefusesOrbitsThatAreNotAsLongAsTheirPeriod) {
  const Json good = orbits_example();
  for (const char* place :
       {"/conditions/0/orbits/0/points", "/branches/0/points/0/points", "/bifurcations/0/orbit/points"}) {
    Json bad = good;
    bad[Json::json_pointer(place)].push_back({0.0, 0.0, 0.0});
    EXPECT_THAT(refusal(bad), HasSubstr(place));
    bad[Json::json_pointer(place)] = Json::array();
    EXPECT_THAT(refusal(bad), HasSubstr("at least one state"));
  }
}

TEST(OrbitsReport, RefusesBranchesOverWhatIsNotSwept) {
  Json bad = orbits_example();
  bad["parameter"] = "/block/width_m";
  EXPECT_THAT(refusal(bad), HasSubstr("/conditions/0/parameters"));
  bad = orbits_example();
  bad["range"] = {1.0, 1.0};
  EXPECT_THAT(refusal(bad), HasSubstr("/range/1"));
  Json partly = orbits_example();
  partly.erase("range");
  EXPECT_THAT(refusal(partly), HasSubstr("/range = null: is missing"));
}

// The orbits beside a grazing, at the ends of a branch, may have an impact more than the others.
TEST(OrbitsReport, NamesABranchByTheClassOfMostOfItsOrbits) {
  OrbitBranch branch{.period = 3};
  for (const int cycles : {2, 1, 1, 2, 1}) {
    Orbit orbit;
    orbit.period = 3;
    orbit.cycles = cycles;
    orbit.points.resize(3);
    branch.points.push_back({.value = 0.5, .orbit = orbit});
  }
  OrbitStudy study;
  study.conditions.emplace_back().parameters = {{.pointer = "/restitution", .value = 0.5}};
  study.branches.emplace().pointer = "/restitution";
  study.branches->study.branches = {branch};
  EXPECT_THAT(table_of(study), HasSubstr(" (1,3) "));
  EXPECT_EQ(
      Json::parse(orbits_document().text({.input = {}, .study = study})).at(Json::json_pointer("/branches/0/cycles")),
      1);
}

}  // namespace
