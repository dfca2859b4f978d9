// Takes the dialect's macros back after a text has been read (no include guard: once a precision).
#undef FN
#undef OUT
#undef CONSTANT
