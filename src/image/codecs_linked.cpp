// Codecs that are part of the program: for fuzzers, whose instruments must see them.
#include "image/codecs/oiio_codecs.hpp"

namespace burnish {

const Codecs& codecs() {
    return oiio::codecs();
}

}  // namespace burnish
