# `brdf eval` of the further models against the oracle.
burnish_test(cli_brdf_oracle_tests SOURCES further_brdfs_test.cpp program.cpp LIBRARIES burnish_oracle)
target_compile_definitions(cli_brdf_oracle_tests PRIVATE BURNISH_PROGRAM="$<TARGET_FILE:burnish_cli>")
add_dependencies(cli_brdf_oracle_tests burnish_cli)
