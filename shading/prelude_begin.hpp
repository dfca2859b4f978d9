// The dialect's macros, around the reading of the texts only (no include guard: once a precision).
#define FN inline
#define OUT(T) T&
