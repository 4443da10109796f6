mod figure;
mod measure;
