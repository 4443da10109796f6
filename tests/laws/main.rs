mod scene_file;
