// The dialect's macros, around the reading of the texts only (no include guard: once a precision).
#define FN inline
#define OUT(T) T&
#define CONSTANT(name, value) inline constexpr Float name = static_cast<Float>(value);
