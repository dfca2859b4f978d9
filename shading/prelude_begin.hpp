// The dialect's macros, around the reading of the texts only (no include guard: once a precision). Macros
// of the same names that a program has (OUT is one of Windows) are set aside and come back.
#pragma push_macro("FN")
#pragma push_macro("OUT")
#pragma push_macro("CONSTANT")
#undef FN
#undef OUT
#undef CONSTANT
#define FN inline
#define OUT(T) T&
#define CONSTANT(name, value) inline constexpr Float name = static_cast<Float>(value);
