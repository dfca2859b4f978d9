// Takes the dialect's macros back after a text has been read (no include guard: once a precision).
#undef FN
#undef OUT
#undef CONSTANT
#pragma pop_macro("FN")
#pragma pop_macro("OUT")
#pragma pop_macro("CONSTANT")
