// Films of numbered pictures. The program ffmpeg makes them; nothing else needs it.
//
// Threads: functions may be called from any thread.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/progress.hpp"
#include "burnish/render_settings.hpp"

namespace burnish {

bool is_film(const std::filesystem::path& path);           // .mp4, .webm or .apng, in any case
bool film_holds_alpha(const std::filesystem::path& path);  // .apng

// The background of its pictures: the color in place of transparency that the film cannot keep, as
// colors at the rim of a model are not weakened by their coverage.
BackgroundKind film_background(const std::filesystem::path& film, BackgroundKind asked);

// The name of which the pictures of a film are numbered: "a/turn.mp4" -> "a/turn_frames/turn.png".
std::filesystem::path film_pictures(const std::filesystem::path& film);

struct FilmRequest {
    std::filesystem::path output;
    int first = 0, count = 1;  // of the pictures numbered(film_pictures(output)), all of one size
    int fps = 24;
    int width = 0, height = 0;  // of the pictures, in pixels
    bool alpha = false;         // keeps their alpha: film_holds_alpha
    std::string comment;        // a line of metadata
};

// Throws Error where ffmpeg, or its encoder for this film, is missing: before pictures are drawn.
void require_film_maker(const std::filesystem::path& film);

// Whether the film is one column or row larger than the pictures: 4:2:0 chroma needs even sizes. The
// last column or row is repeated.
bool film_is_padded(const FilmRequest& request);

// Writes the film whole or not at all. Throws Error with the first line of what ffmpeg says.
void make_film(const FilmRequest& request, const Progress& progress);

// Deletes the pictures of the film, and their folder where nothing else is in it.
void remove_film_pictures(const FilmRequest& request);

}  // namespace burnish
