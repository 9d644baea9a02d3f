# SPDX-License-Identifier: MIT
# Which module may use which: the architecture, as one list. The build links by it, the installed package resolves its
# components by it, and tests/layers checks every include by it. It only sets variables, so that `cmake -P` can read it too.
# A module may use what its line names and what those use (one way only).

set(MOIVRE_MODULES numeric factorization expression polynomial algebra certify homotopy tracker tracker_cvode tracker_lanes multiprecision endgame
    start bounds check solver family study mechanism urdf kinematics formulation closures motion design arms closure_study sweep report closure_report
    arm_report study_report run_ledger mpi_ranks cli)

set(MOIVRE_USES_numeric "")
set(MOIVRE_USES_run_ledger numeric)
set(MOIVRE_USES_mpi_ranks numeric)
set(MOIVRE_USES_factorization numeric)
set(MOIVRE_USES_expression numeric)
set(MOIVRE_USES_polynomial expression factorization)
# Exact algebra: what integers modulo a prime tell of a system's roots.
set(MOIVRE_USES_algebra polynomial)
set(MOIVRE_USES_certify algebra)
set(MOIVRE_USES_homotopy polynomial)
set(MOIVRE_USES_tracker homotopy)
set(MOIVRE_USES_tracker_cvode tracker)
set(MOIVRE_USES_tracker_lanes tracker)
set(MOIVRE_USES_multiprecision tracker)
set(MOIVRE_USES_endgame tracker)
set(MOIVRE_USES_start homotopy algebra)
set(MOIVRE_USES_solver bounds endgame certify multiprecision)
set(MOIVRE_USES_bounds start)
set(MOIVRE_USES_family solver)
# The judge of a result shares nothing with what makes one: no tracker, no endgame, no solver.
set(MOIVRE_USES_check certify bounds)
set(MOIVRE_USES_study multiprecision solver)
set(MOIVRE_USES_mechanism expression)
set(MOIVRE_USES_urdf mechanism)
set(MOIVRE_USES_kinematics mechanism factorization)
set(MOIVRE_USES_formulation mechanism polynomial)
set(MOIVRE_USES_closures kinematics formulation solver certify)
set(MOIVRE_USES_motion closures)
# An arm's polynomials need no Phi: what puts its joint values right is the product of its transforms.
set(MOIVRE_USES_arms urdf family)
set(MOIVRE_USES_closure_study motion study)
set(MOIVRE_USES_sweep closures family)
# What is told of systems: roots, paths, judgements, families.
set(MOIVRE_USES_report check family)
set(MOIVRE_USES_design motion)
# What is told of mechanisms: closures, motions, sweeps.
set(MOIVRE_USES_closure_report design sweep report)
# A robot's postures are drawn by what draws closures.
set(MOIVRE_USES_arm_report arms closure_report)
set(MOIVRE_USES_study_report study report)
set(MOIVRE_USES_cli closure_study multiprecision report study_report closure_report arm_report tracker_cvode tracker_lanes run_ledger
    mpi_ranks)

# Linked by one program alone (moivre-mpi), and not installed: moivre starts where there is no MPI.
set(MOIVRE_OF_PROGRAMS mpi_ranks)

# Where a module is switched off, those named here make do without it; cli makes do with what is there.
set(MOIVRE_DO_WITHOUT_multiprecision solver)

# Modules that read, decide and write: their time goes into what they call, so that optimizing their own code further only
# lengthens the build.
set(MOIVRE_LIGHT run_ledger mpi_ranks expression multiprecision family bounds check study urdf formulation design arms closure_study sweep report closure_report
    arm_report study_report cli)

# Modules that add compiler flags of their own.
set(MOIVRE_OWN_FLAGS certify tracker_lanes)

# Third-party packages, each private to the modules that name it. Eigen and Boost's integers are
# the exception: they are vocabulary of the public headers.
set(MOIVRE_THIRD_PARTY_numeric Boost::headers)
set(MOIVRE_THIRD_PARTY_run_ledger SQLite::SQLite3)
set(MOIVRE_THIRD_PARTY_mpi_ranks MPI::MPI_C)
set(MOIVRE_THIRD_PARTY_factorization Eigen3::Eigen)
set(MOIVRE_THIRD_PARTY_expression taocpp::pegtl)
set(MOIVRE_THIRD_PARTY_multiprecision MPFR::MPFR)
set(MOIVRE_THIRD_PARTY_certify Arb::Arb)
set(MOIVRE_THIRD_PARTY_tracker_cvode SUNDIALS::cvode)
set(MOIVRE_THIRD_PARTY_tracker_lanes hwy::hwy)
set(MOIVRE_THIRD_PARTY_solver TBB::tbb)
set(MOIVRE_THIRD_PARTY_family nlohmann_json::nlohmann_json)
set(MOIVRE_THIRD_PARTY_mechanism Eigen3::Eigen tomlplusplus::tomlplusplus)
set(MOIVRE_THIRD_PARTY_urdf pugixml::pugixml)
set(MOIVRE_THIRD_PARTY_check nlohmann_json::nlohmann_json)
set(MOIVRE_THIRD_PARTY_report nlohmann_json::nlohmann_json)
set(MOIVRE_THIRD_PARTY_closure_report nlohmann_json::nlohmann_json)
set(MOIVRE_THIRD_PARTY_arm_report nlohmann_json::nlohmann_json)
set(MOIVRE_THIRD_PARTY_study_report nlohmann_json::nlohmann_json)
set(MOIVRE_THIRD_PARTY_cli CLI11::CLI11)

# What is known of each package: the arguments of find_package, and how its headers begin (a regular expression).
# Of a package in MOIVRE_HEADER_ONLY only the headers are used, and nothing is linked: a consumer of the installed library
# needs it only where it is vocabulary of the public headers (MOIVRE_VOCABULARY).
set(MOIVRE_FIND_Eigen3::Eigen Eigen3 3.4)
# By the file that Boost brings: CMake means to have no finder of its own for it, and says so from 3.30.
set(MOIVRE_FIND_Boost::headers Boost 1.74 CONFIG)
set(MOIVRE_FIND_taocpp::pegtl pegtl 3.2)
set(MOIVRE_FIND_SQLite::SQLite3 SQLite3 3.40)
# SUNDIALS 7 on MPI names MPI's C++ target, too, and looks for none where there is that of C.
set(MOIVRE_FIND_MPI::MPI_C MPI 3.0 COMPONENTS C OPTIONAL_COMPONENTS CXX)
set(MOIVRE_FIND_MPFR::MPFR MPFR 4.0)
set(MOIVRE_FIND_Arb::Arb Arb 2.23)
set(MOIVRE_FIND_SUNDIALS::cvode SUNDIALS 6.4)
set(MOIVRE_FIND_hwy::hwy hwy 1.0)
set(MOIVRE_FIND_TBB::tbb TBB 2021.8)
set(MOIVRE_FIND_nlohmann_json::nlohmann_json nlohmann_json 3.11)
set(MOIVRE_FIND_tomlplusplus::tomlplusplus tomlplusplus 3.3)
set(MOIVRE_FIND_pugixml::pugixml pugixml 1.12)
set(MOIVRE_FIND_CLI11::CLI11 CLI11 2.1)

set(MOIVRE_HEADERS_Eigen3::Eigen "(Eigen|unsupported/Eigen)/")
set(MOIVRE_HEADERS_Boost::headers "boost/")
set(MOIVRE_HEADERS_taocpp::pegtl "tao/pegtl")
set(MOIVRE_HEADERS_SQLite::SQLite3 "sqlite3\\.h")
set(MOIVRE_HEADERS_MPI::MPI_C "mpi\\.h")
set(MOIVRE_HEADERS_MPFR::MPFR "(boost/multiprecision/)?(mpfr|gmp|mpc)\\.h")
set(MOIVRE_HEADERS_Arb::Arb "(flint/|(arb|acb|arf|mag|acb_mat|arb_fmpz_poly)\\.h)")
set(MOIVRE_HEADERS_SUNDIALS::cvode "(cvode|sundials|nvector|sunmatrix|sunlinsol|sunnonlinsol)/")
set(MOIVRE_HEADERS_hwy::hwy "hwy/")
set(MOIVRE_HEADERS_TBB::tbb "(tbb|oneapi)/")
set(MOIVRE_HEADERS_nlohmann_json::nlohmann_json "nlohmann/")
set(MOIVRE_HEADERS_tomlplusplus::tomlplusplus "toml\\+\\+/")
set(MOIVRE_HEADERS_pugixml::pugixml "pugi(xml|config)\\.hpp")
set(MOIVRE_HEADERS_CLI11::CLI11 "CLI/")

# How moivre.pc names what a module links: a package of pkg-config, or the linker's argument where there is none. MPFR's and Arb's
# arguments follow from the files that were found.
set(MOIVRE_PC_Eigen3::Eigen eigen3)
set(MOIVRE_PC_SUNDIALS::cvode -lsundials_cvode)
set(MOIVRE_PC_SQLite::SQLite3 sqlite3)
set(MOIVRE_PC_TBB::tbb tbb)
set(MOIVRE_PC_tomlplusplus::tomlplusplus tomlplusplus)
set(MOIVRE_PC_pugixml::pugixml pugixml)

set(MOIVRE_VOCABULARY Eigen3::Eigen Boost::headers)
set(MOIVRE_HEADER_ONLY Eigen3::Eigen Boost::headers taocpp::pegtl nlohmann_json::nlohmann_json
    CLI11::CLI11 hwy::hwy)

# moivre_closure(<variable> <module>...): the modules and everything they use, in the order of MOIVRE_MODULES.
function(moivre_closure variable)
  set(wanted ${ARGN})
  set(reversed ${MOIVRE_MODULES})
  list(REVERSE reversed)
  set(closure "")
  foreach(module IN LISTS reversed)
    if(module IN_LIST wanted)
      list(APPEND wanted ${MOIVRE_USES_${module}})
      list(PREPEND closure ${module})
    endif()
  endforeach()
  set(${variable} ${closure} PARENT_SCOPE)
endfunction()
