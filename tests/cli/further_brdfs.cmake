# `brdf eval` of the further models against the oracle.
burnish_test(cli_brdf_oracle_tests PROGRAM SOURCES further_brdfs_test.cpp LIBRARIES burnish_oracle)
