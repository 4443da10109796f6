mod film;
mod film_files;
