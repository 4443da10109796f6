//! Laws of picture files: what a round trip loses, what is refused, and that nothing half-written stays.

use crate::film::{config, picture, speckle};
use lightbench::color::{Rgb, srgb_encode};
use lightbench::film::Image;
use lightbench::num::gamma;
use lightbench_kit::compare::{CompareError, compare};
use lightbench_kit::file::{self, FileError, Format, read, write, write_as, write_atomically};
use proptest::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// An empty folder for one test.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("film").join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a scratch folder");
    path
}

fn names(folder: &Path) -> Vec<String> {
    let entry =
        |e: std::io::Result<fs::DirEntry>| e.expect("an entry").file_name().into_string().expect("UTF-8");
    let mut names: Vec<String> = fs::read_dir(folder).expect("a folder").map(entry).collect();
    names.sort();
    names
}

fn round_trip(name: &str, image: &Image, format: Format) -> Image {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("film").join(name);
    write_as(&path, image, format, &[]).expect("written");
    read(&path).expect("read back")
}

fn channels(image: &Image) -> impl Iterator<Item = f64> {
    image.pixels().iter().flat_map(|p| p.to_array())
}

/// Radiances that Radiance can hold, over its whole range.
fn rgbe_range() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![0.0..2.0f64, (-140.0..126.9f64).prop_map(f64::exp2), Just(0.0), Just(0.99999), Just(1.0)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..config() })]

    /// Nearest level of the curve: half a level, what the curve rounds (γ₁₂) and decodes (γ₄₄ after its
    /// slope), and the gap at the knee (2.9e-8).
    #[test]
    fn png_keeps_display_values_to_half_a_level(image in picture(-0.2..1.2f64, 6)) {
        for (format, levels) in [(Format::Png8, 255.0), (Format::Png16, 65535.0)] {
            let back = round_trip("half_a_level.png", &image, format);
            for (x, y) in channels(&image).zip(channels(&back)) {
                let error = (srgb_encode(x.clamp(0.0, 1.0)) - srgb_encode(y)).abs();
                prop_assert!(error <= 0.5 / levels + gamma(56) + 2.9e-8, "{format:?} {x} {y}");
            }
        }
    }

    /// `f32`, rounded to nearest: half a unit in the 24th place, or of the subnormal step 2⁻¹⁴⁹.
    #[test]
    fn exr_keeps_24_bits(image in picture(prop_oneof![-4.0..4.0f64, rgbe_range()], 6)) {
        let back = round_trip("24_bits.exr", &image, Format::Exr);
        for (x, y) in channels(&image).zip(channels(&back)) {
            prop_assert!((x - y).abs() <= (x.abs() * 2f64.powi(-24)).max(2f64.powi(-150)), "{x} {y}");
        }
    }

    /// 8-bit mantissas under the largest channel's exponent, to nearest: 2⁻⁸ of that channel.
    #[test]
    fn hdr_keeps_8_bits_of_the_largest_channel(image in picture(rgbe_range(), 12)) {
        let back = round_trip("8_bits.hdr", &image, Format::Hdr);
        for (p, q) in image.pixels().iter().zip(back.pixels()) {
            // Pixels below 2^−127 are black.
            let bound = (p.max_element() * 2f64.powi(-8)).max(if p.max_element() < 2f64.powi(-126) { 2f64.powi(-127) } else { 0.0 });
            prop_assert!((*p - *q).abs().max_element() <= bound, "{p} {q}");
        }
    }
}

/// All 256 levels come back as themselves, and are read as what the curve says.
#[test]
fn stored_levels_survive_rewriting() {
    let level = |i: usize| lightbench::color::srgb_decode(i as f64 / 255.0);
    let ramp = Image::from_fn(256, 1, |x, _| Rgb::splat(level(x)));
    assert_eq!(round_trip("ramp.png", &ramp, Format::Png8), ramp);
    // 257 · 255 = 65535: every 8-bit level is a 16-bit level.
    let fine = round_trip("ramp16.png", &ramp, Format::Png16);
    for (x, y) in channels(&ramp).zip(channels(&fine)) {
        assert!((x - y).abs() <= gamma(2) * x, "{x} {y}");
    }
    assert_eq!(round_trip("ramp.exr", &fine, Format::Exr).width(), 256);
}

/// A mean of many pixels shows a bias that one pixel cannot: truncated mantissas would lose 1/512 of the
/// largest channel, rounding leaves the scatter of 30 000 errors of at most 1/256, uniform: 1/(256 √3 · 173).
#[test]
fn hdr_is_not_darker_on_average() {
    let image = speckle(100, 100, 5).map(|p| p + 0.5);
    let back = round_trip("mean.hdr", &image, Format::Hdr);
    let bias = (back.sum() - image.sum()).element_sum() / 30_000.0;
    // Steps are 1/256 at most (values below 2: largest channel in [1,2) or [0.5,1)); z = 6.
    let sigma = (1.0 / 128.0) / 12f64.sqrt() / 30_000f64.sqrt();
    assert!(bias.abs() <= 6.0 * sigma, "{bias:e}, σ {sigma:e}");
}

#[test]
fn a_png_says_that_it_is_srgb_and_where_it_comes_from() {
    let path = folder("metadata").join("x.png");
    let metadata = [("Software", "lightbench".to_string()), ("Description", "σ = ½, in m²".to_string())];
    write(&path, &speckle(4, 3, 1), &metadata).expect("written");
    let bytes = fs::read(&path).expect("bytes");
    let at = |chunk: &[u8]| bytes.windows(4).position(|w| w == chunk);
    assert!(at(b"sRGB").expect("an sRGB chunk") < at(b"IDAT").expect("pixels"));
    assert!(at(b"gAMA").is_some() && at(b"cHRM").is_some());
    let reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().expect("a PNG");
    assert!(reader.info().srgb.is_some());
    assert_eq!(reader.info().uncompressed_latin1_text[0].text, "lightbench");
    assert_eq!(reader.info().utf8_text[0].get_text().expect("text"), "σ = ½, in m²");
}

#[test]
fn the_same_picture_gives_the_same_bytes() {
    let image = speckle(130, 70, 9);
    for format in [Format::Png8, Format::Png16, Format::Exr, Format::Hdr] {
        let bytes = || file::encode(Path::new("x"), &image, format, &[]).expect("bytes").0;
        assert_eq!(bytes(), bytes(), "{format:?}");
    }
}

#[test]
fn an_hdr_carries_its_provenance_and_its_exposure() {
    let path = folder("exposure").join("x.hdr");
    let image = Image::from_fn(9, 2, |x, _| Rgb::splat(x as f64));
    write(&path, &image, &[("Command", "two\nlines".to_string())]).expect("written");
    assert_eq!(read(&path).expect("read"), image, "small integers have short mantissas");
    let bytes = fs::read(&path).expect("bytes");
    assert!(bytes.starts_with(b"#?RADIANCE\n# Command: two lines\n"));
    let marked = [b"#?RADIANCE\nEXPOSURE=4\n", &bytes[11..]].concat();
    fs::write(&path, marked).expect("bytes");
    assert_eq!(read(&path).expect("read"), image.map(|p| p / 4.0));
}

/// Grey, opacity, 16 bits, JPEG and TGA, as other programs write them.
#[test]
fn foreign_pictures_are_read_as_linear_colours() {
    use image::{DynamicImage, ImageBuffer, Luma, LumaA, Rgb as Stored, Rgba};
    let folder = folder("foreign");
    let save = |name: &str, picture: DynamicImage| {
        picture.save(folder.join(name)).expect("saved");
        read(&folder.join(name)).expect("read").get(0, 0)
    };
    let level = |x: f64| lightbench::color::srgb_decode(x);
    let grey = Rgb::splat(level(51.0 / 255.0));
    let colour = Rgb::new(level(51.0 / 255.0), level(1.0), 0.0);
    let (w, h) = (3, 2);
    assert_eq!(save("l8.png", ImageBuffer::from_pixel(w, h, Luma([51u8])).into()), grey);
    assert_eq!(save("la8.png", ImageBuffer::from_pixel(w, h, LumaA([51u8, 7])).into()), grey);
    assert_eq!(save("rgb8.png", ImageBuffer::from_pixel(w, h, Stored([51u8, 255, 0])).into()), colour);
    assert_eq!(save("rgba8.png", ImageBuffer::from_pixel(w, h, Rgba([51u8, 255, 0, 9])).into()), colour);
    assert_eq!(save("rgba8.tga", ImageBuffer::from_pixel(w, h, Rgba([51u8, 255, 0, 9])).into()), colour);
    let wide = Rgb::new(level(1000.0 / 65535.0), level(1.0), 0.0);
    assert_eq!(save("rgb16.png", ImageBuffer::from_pixel(w, h, Stored([1000u16, 65535, 0])).into()), wide);
    assert_eq!(save("rgba16.png", ImageBuffer::from_pixel(w, h, Rgba([1000u16, 65535, 0, 9])).into()), wide);
    let narrow = Rgb::splat(level(1000.0 / 65535.0));
    assert_eq!(save("l16.png", ImageBuffer::from_pixel(w, h, Luma([1000u16])).into()), narrow);
    assert_eq!(save("la16.png", ImageBuffer::from_pixel(w, h, LumaA([1000u16, 1])).into()), narrow);
    // JPEG quantises the one coefficient of an even block: a level or two.
    let jpeg = save("l8.jpg", ImageBuffer::from_pixel(8, 8, Luma([51u8])).into());
    assert!((srgb_encode(jpeg.x) * 255.0 - 51.0).abs() <= 2.5);
    // The content decides, whatever the name says.
    fs::copy(folder.join("l8.png"), folder.join("named.txt")).expect("copied");
    assert_eq!(read(&folder.join("named.txt")).expect("read").get(0, 0), grey);
}

#[test]
fn what_a_format_cuts_off_is_counted() {
    let mut image = speckle(4, 4, 2);
    image.set(0, 0, Rgb::new(1.5, 0.0, 0.0));
    image.set(1, 0, Rgb::new(0.5, -0.5, 2.0));
    let folder = folder("clipped");
    let clipped = |name: &str| write(&folder.join(name), &image, &[]).expect("written").clipped;
    assert_eq!((clipped("x.png"), clipped("x.hdr"), clipped("x.exr")), (2, 1, 0));
}

/// NaN and what is too large: one clear error that names the pixel, and no file; EXR keeps NaN.
#[test]
fn pixels_that_a_format_cannot_hold_are_refused() {
    let folder = folder("refused");
    let spoiled = |value: f64| {
        let mut image = speckle(5, 4, 2);
        image.set(3, 1, Rgb::new(0.0, value, 0.0));
        image.set(0, 2, Rgb::splat(value));
        image
    };
    for (name, value) in [
        ("x.png", f64::NAN),
        ("x.png", f64::INFINITY),
        ("x.hdr", f64::NAN),
        ("x.hdr", f64::NEG_INFINITY),
        ("x.hdr", 2f64.powi(127)),
        ("x.hdr", 2f64.powi(127).next_down()),
        ("x.exr", 1e39),
        ("x.exr", -1e300),
    ] {
        let error = write(&folder.join(name), &spoiled(value), &[]).expect_err(name);
        assert!(matches!(error, FileError::Value { count: 2, x: 3, y: 1, .. }), "{error}");
        assert!(error.to_string().contains(name) && error.to_string().contains("column 3, row 1"), "{error}");
    }
    for empty in [Image::new(0, 3), Image::new(3, 0)] {
        for name in ["x.png", "x.exr", "x.hdr"] {
            assert!(matches!(write(&folder.join(name), &empty, &[]), Err(FileError::Size { .. })));
        }
    }
    let bad_key = [("", "no keyword".to_string())];
    assert!(matches!(
        write(&folder.join("x.png"), &Image::new(1, 1), &bad_key),
        Err(FileError::Encode { .. })
    ));
    assert!(matches!(write(&folder.join("x.gif"), &Image::new(1, 1), &[]), Err(FileError::Ending { .. })));
    assert_eq!(names(&folder), [""; 0]);
    write(&folder.join("x.exr"), &spoiled(f64::NAN), &[]).expect("EXR holds NaN");
    assert!(read(&folder.join("x.exr")).expect("read").get(3, 1).y.is_nan());
}

#[test]
fn a_failed_write_leaves_no_trace_and_the_old_file() {
    let folder = folder("atomic");
    // In place of the file there is a folder that is not empty: the last step, the renaming, fails.
    fs::create_dir_all(folder.join("taken.png/inside")).expect("a folder");
    let error = write(&folder.join("taken.png"), &Image::new(2, 2), &[]).expect_err("a folder is no file");
    assert!(error.to_string().contains("taken.png: cannot"), "{error}");
    // A file where a folder is needed: nothing can be created.
    fs::write(folder.join("file"), "old").expect("a file");
    assert!(matches!(write_atomically(&folder.join("file/x.csv"), b"new"), Err(FileError::Io { .. })));
    // A refused picture leaves the one that stood there.
    fs::write(folder.join("old.png"), "old").expect("a file");
    let nan = Image::from_fn(1, 1, |_, _| Rgb::NAN);
    assert!(write(&folder.join("old.png"), &nan, &[]).is_err());
    assert_eq!(fs::read(folder.join("old.png")).expect("bytes"), b"old");
    assert_eq!(names(&folder), ["file", "old.png", "taken.png"]);
    assert_eq!(names(&folder.join("taken.png")), ["inside"]);
    for path in ["", "/"] {
        assert!(write_atomically(Path::new(path), b"new").is_err());
    }
}

#[test]
fn a_write_creates_folders_and_replaces_what_stood_there() {
    let folder = folder("replaced");
    let path = folder.join("deep/er/x.csv");
    write_atomically(&path, b"a long first version").expect("written");
    write_atomically(&path, b"second").expect("written");
    assert_eq!(fs::read(&path).expect("bytes"), b"second");
    assert_eq!(names(&folder.join("deep/er")), ["x.csv"]);
}

#[cfg(unix)]
#[test]
fn a_write_follows_links_and_leaves_devices_in_place() {
    use std::os::unix::fs::FileTypeExt;
    let folder = folder("links");
    fs::write(folder.join("real"), "old").expect("a file");
    std::os::unix::fs::symlink("real", folder.join("link")).expect("a link");
    write_atomically(&folder.join("link"), b"new").expect("written");
    assert_eq!(fs::read(folder.join("real")).expect("bytes"), b"new");
    assert!(fs::symlink_metadata(folder.join("link")).expect("a link").is_symlink());
    write_atomically(Path::new("/dev/null"), b"gone").expect("written");
    assert!(fs::metadata("/dev/null").expect("there").file_type().is_char_device());
}

#[test]
fn unreadable_pictures_are_errors_that_name_the_file() {
    let folder = folder("unreadable");
    let fails = |name: &str| {
        let error = read(&folder.join(name)).expect_err(name);
        assert!(error.to_string().contains(name), "{error}");
        error
    };
    assert!(matches!(fails("missing.png"), FileError::Io { .. }));
    assert!(matches!(fails(""), FileError::Io { .. } | FileError::Ending { .. }));
    fs::write(folder.join("words.txt"), "no picture").expect("a file");
    assert!(matches!(fails("words.txt"), FileError::Ending { .. }));
    for format in [Format::Png8, Format::Png16, Format::Exr, Format::Hdr] {
        let name = format!("cut.{}", format.extension());
        let (bytes, _) = file::encode(Path::new(&name), &speckle(20, 10, 4), format, &[]).expect("bytes");
        for length in [0, 4, 12, 40, bytes.len() / 2, bytes.len() - 20] {
            fs::write(folder.join(&name), &bytes[..length]).expect("a file");
            assert!(matches!(fails(&name), FileError::Decode { .. }), "{name} {length}");
        }
    }
}

#[test]
fn compare_prints_a_table_and_draws_the_error() {
    let folder = folder("compare");
    let (a, b, out) = (folder.join("a.exr"), folder.join("b.exr"), folder.join("new/error.png"));
    let reference = Image::from_fn(12, 11, |_, _| Rgb::splat(0.5));
    let mut picture = reference.clone();
    picture.set(7, 2, Rgb::new(0.5, 0.25, 0.5));
    write(&a, &picture, &[]).expect("written");
    write(&b, &reference, &[]).expect("written");
    let report = compare(&a, &b, Some(&out)).expect("a table");
    let text = report.table + &report.picture.expect("written");
    assert!(text.contains("-2.5000e-1  at column 7, row 2, green"), "{text}");
    assert!(text.ends_with(&format!("{}\n", out.display())), "{text}");
    let drawn = read(&out).expect("a picture");
    assert_eq!(drawn.get(0, 0), Rgb::ONE);
    assert!(drawn.get(7, 2).z > 2.0 * drawn.get(7, 2).x, "too dark is blue");
    let bytes = fs::read(&out).expect("bytes");
    assert!(String::from_utf8_lossy(&bytes).contains("blue -2.5e-1, white 0, red 2.5e-1"));
    let same = compare(&a, &a, None).expect("a table").table;
    assert!(same.contains("inf (identical)") && same.contains("1.000000"), "{same}");
}

#[test]
fn compare_refuses_different_sizes_and_unknown_endings() {
    let folder = folder("compare_sizes");
    let (a, b) = (folder.join("a.png"), folder.join("b.png"));
    write(&a, &Image::new(4, 3), &[]).expect("written");
    write(&b, &Image::new(3, 4), &[]).expect("written");
    let error = compare(&a, &b, Some(&folder.join("e.png"))).expect_err("sizes");
    assert!(matches!(error, CompareError::Sizes { a_size: (4, 3), b_size: (3, 4), .. }));
    assert!(error.to_string().contains("4 × 3") && error.to_string().contains("3 × 4"), "{error}");
    assert!(matches!(compare(&a, &a, Some(Path::new("e.svg"))), Err(CompareError::File(_))));
    assert!(matches!(compare(&a, &folder.join("none.png"), None), Err(CompareError::File(_))));
    assert_eq!(names(&folder), ["a.png", "b.png"]);
}
