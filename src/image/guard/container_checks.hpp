// The walks over the containers that are no PNG, JPEG, OpenEXR or Radiance HDR: each refuses a file
// that is cut short, declares a size out of bounds, or is of a kind that is not read.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "image/guard/byte_cursor.hpp"

namespace burnish {

// RIFF chunks to the first frame. Needed until OpenImageIO asks for the size of a WebP before it
// decodes: 2.4 decodes on opening.
void check_webp(const ByteCursor& file);

// A WebP of the colors alone. OpenImageIO 2.4 multiplies them by alpha, at 8 bits, whatever it is
// asked: they are lost where alpha is small. `bytes` have passed check_webp.
std::vector<std::byte> webp_without_alpha(std::span<const std::byte> bytes);

// Headers, palette, rows or runs. Needed until OpenImageIO bounds palettes, indices and runs.
void check_bmp(const ByteCursor& file);

// Whether 18 bytes are a consistent TGA header; the format has no signature.
bool is_tga_head(std::span<const std::byte> head);

// Header, rows or runs, and what the end says. Needed until OpenImageIO bounds runs and the areas
// behind the picture.
ImageStructure check_tga(const ByteCursor& file);

// The file without its end ("TRUEVISION-XFILE."), so that the decoder reads neither thumbnails nor
// tables. `bytes` have passed check_tga.
std::span<const std::byte> without_tga_end(std::span<const std::byte> bytes);

// Boxes of the outermost level, each within the file.
void check_boxes(const ByteCursor& file);

// Boxes of HEIF and AVIF, and the sizes of all pictures in them. Needed until OpenImageIO asks for
// the size before it decodes: 2.4 decodes on opening.
void check_heif(const ByteCursor& file);

// The directories of a TIFF: sizes within bounds.
void check_tiff(const ByteCursor& file);

// Whether a TIFF is a camera's: its first picture is a preview, it holds sensor data, it says that
// it is a DNG, or its name ends as a raw file's does. A reader of TIFF would show the preview.
bool is_raw_tiff(const ByteCursor& file);

// Raw camera files: the sensor data lie within the file, where the container says so in a way that
// all makers share.
void check_raw(const ByteCursor& file);
void check_raw_tiff(const ByteCursor& file);

}  // namespace burnish
