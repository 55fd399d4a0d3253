# What `tests/all --release` adds. CONTRIBUTING.md says which change needs it.

if(TARGET rocking_python)
  add_test(NAME python/asking_more COMMAND ${CMAKE_COMMAND} -E env ROCKING_CALLS=3000
    ${test_python} ${CMAKE_CURRENT_SOURCE_DIR}/python/test_asking.py)
  set_tests_properties(python/asking_more PROPERTIES TIMEOUT 1800 LABELS python COST 400)
endif()

# Each creates its own hosts or cluster and needs the superuser; skipped with a message where that is impossible.
add_test(NAME Cluster.RanksOnTwoHostsGiveTheBytesOfOneProcess
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/cluster/mpi_between_hosts $<TARGET_FILE:rocking>)
add_test(NAME Cluster.SlurmTasksKilledAndRequeuedGiveTheBytesOfOneProcess
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/cluster/slurm_array $<TARGET_FILE:rocking>)
set_tests_properties(
  Cluster.RanksOnTwoHostsGiveTheBytesOfOneProcess Cluster.SlurmTasksKilledAndRequeuedGiveTheBytesOfOneProcess
  PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600 LABELS cluster PROCESSORS 2)
add_test(NAME Golden.HasTheSameBitsWithEveryCompilerAndProcessor COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/golden/everywhere)
set_tests_properties(Golden.HasTheSameBitsWithEveryCompilerAndProcessor PROPERTIES
  SKIP_RETURN_CODE 77 TIMEOUT 1800 LABELS golden PROCESSORS 2 COST 250)

add_test(NAME Reproducibility.VerifiesThePublishedRunByItsOwnRevision
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/reproducibility/by_its_own_revision)
set_tests_properties(Reproducibility.VerifiesThePublishedRunByItsOwnRevision PROPERTIES
  SKIP_RETURN_CODE 77 TIMEOUT 3600 LABELS reproducibility PROCESSORS 2 COST 600)

# live.html in Chromium, and its engine without a browser.
add_test(NAME Live.IsBuilt COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target live)
set_tests_properties(Live.IsBuilt PROPERTIES
  FIXTURES_SETUP live SKIP_REGULAR_EXPRESSION "live.html needs" TIMEOUT 1800 LABELS browser PROCESSORS 2 COST 400)
add_test(NAME Live.HasTheBitsOfTheProgramInABrowser
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/browser/run $<TARGET_FILE:rocking> ${CMAKE_CURRENT_BINARY_DIR}/live ${PROJECT_BINARY_DIR}/live.html)
set_tests_properties(Live.HasTheBitsOfTheProgramInABrowser PROPERTIES
  FIXTURES_REQUIRED live SKIP_RETURN_CODE 77 TIMEOUT 900 LABELS browser COST 120)

add_test(NAME Live.HasACopyWithTheBitsOfTheProgram
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/live/run $<TARGET_FILE:rocking> ${PROJECT_SOURCE_DIR}/reports/live.html)
set_tests_properties(Live.HasACopyWithTheBitsOfTheProgram PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300 LABELS browser COST 20)

# Installs the packages of the set-up on bare systems made by debootstrap. Each takes about two minutes and needs the
# network. Skipped with a message if debootstrap, the keys of an archive or the network are missing, or if the archive is
# too slow. The system of the build also gets the packages of the build; the others refuse them.
if(ROCKING_INSTALL)
  set(packages ${PROJECT_BINARY_DIR})
  add_test(NAME Install.MakesThePackages COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target packages)
  set_tests_properties(Install.MakesThePackages PROPERTIES FIXTURES_SETUP packages TIMEOUT 600 LABELS install COST 300)
endif()
foreach(suite bookworm trixie noble)
  add_test(NAME Platform.OffersThePackagesOfTheSetUp/${suite} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/platform/bare_system ${suite}
    ${packages})
  set_tests_properties(Platform.OffersThePackagesOfTheSetUp/${suite} PROPERTIES
    FIXTURES_REQUIRED packages SKIP_RETURN_CODE 77 TIMEOUT 600 LABELS platform COST 90)
endforeach()

add_test(NAME Museum.GivesAPageAndAnAnnualRate COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/examples/museum $<TARGET_FILE:rocking>)
set_tests_properties(Museum.GivesAPageAndAnAnnualRate PROPERTIES TIMEOUT 600 LABELS examples COST 25)
if(ROCKING_INSTALL)
  add_test(NAME Install.LetsOthersBuildAgainstIt COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/install/run ${PROJECT_BINARY_DIR})
  add_test(NAME Install.IsAlsoASharedLibraryAndASubproject
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/install/other_ways ${PROJECT_BINARY_DIR})
  set_tests_properties(Install.LetsOthersBuildAgainstIt Install.IsAlsoASharedLibraryAndASubproject PROPERTIES
    TIMEOUT 1800 LABELS install COST 100)
  add_test(NAME Install.MakesADebianPackage
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/install/debian_package ${PROJECT_BINARY_DIR})
  set_tests_properties(Install.MakesADebianPackage PROPERTIES FIXTURES_REQUIRED packages TIMEOUT 600 LABELS install)
endif()
if(ROCKING_INSTALL AND TARGET rocking_python)
  add_test(NAME Install.InstallsThePythonModuleWithPip
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/python/pip_install ${ROCKING_PYTHON_EXECUTABLE} ${PROJECT_BINARY_DIR}
      ${PROJECT_SOURCE_DIR})
  set_tests_properties(Install.InstallsThePythonModuleWithPip PROPERTIES
    FIXTURES_REQUIRED packages SKIP_RETURN_CODE 77 TIMEOUT 600 LABELS install)
endif()
add_test(NAME Documents.AreASiteWithoutWarnings
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/reference/build ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}
    ${ROCKING_PYTHON_EXECUTABLE})
set_tests_properties(Documents.AreASiteWithoutWarnings PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600 LABELS reference)

# `rocking` on damaged and odd input (reports/evidence/fuzzing.md); with sanitizers no limit of memory can hold.
add_test(NAME Attack.FindsNothing COMMAND attack $<TARGET_FILE:rocking> ${ROCKING_ATTACK_SEED} 400)
set_tests_properties(Attack.FindsNothing PROPERTIES TIMEOUT 3600 LABELS fuzz COST 100)
set_target_properties(attack PROPERTIES EXCLUDE_FROM_ALL OFF)
