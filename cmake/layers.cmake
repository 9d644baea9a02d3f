# SPDX-License-Identifier: MIT
# Which module may use which: the architecture, as one list. The build links by it; tests/layers checks the includes by it.
# A module may use what its line names and what those use (one way only).

set(MOIVRE_MODULES numeric expression polynomial homotopy tracker tracker_cvode endgame start solver
    report cli)

set(MOIVRE_USES_numeric "")
set(MOIVRE_USES_expression numeric)
set(MOIVRE_USES_polynomial expression)
set(MOIVRE_USES_homotopy polynomial)
set(MOIVRE_USES_tracker homotopy)
set(MOIVRE_USES_tracker_cvode tracker)
set(MOIVRE_USES_endgame tracker)
set(MOIVRE_USES_start homotopy)
set(MOIVRE_USES_solver start endgame)
set(MOIVRE_USES_report solver)
set(MOIVRE_USES_cli report tracker_cvode)

# Third-party packages, each private to the modules that name it. Eigen and Boost's rationals are
# the exception: they are vocabulary of the public headers.
set(MOIVRE_THIRD_PARTY_numeric Eigen3::Eigen Boost::headers)
set(MOIVRE_THIRD_PARTY_expression taocpp::pegtl)
set(MOIVRE_THIRD_PARTY_tracker_cvode SUNDIALS::cvode)
set(MOIVRE_THIRD_PARTY_solver TBB::tbb)
set(MOIVRE_THIRD_PARTY_report nlohmann_json::nlohmann_json)
set(MOIVRE_THIRD_PARTY_cli CLI11::CLI11)
