use std::fs;
use std::path::PathBuf;

use ::png::{BitDepth, ColorType};

use super::*;

/// A folder for the files of one test.
fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

fn error_of(path: &Path) -> String {
    let error = load_image(path).unwrap_err().to_string();
    assert!(error.starts_with(&path.display().to_string()), "{error}");
    assert!(!error.contains('\n'), "{error}");
    error
}

/// What is darker than the format can hold is black.
#[test]
fn hdr_files_keep_what_is_dark_dark() {
    let folder = folder();
    let path = folder.path().join("dark.hdr");
    let pixels = vec![[1e-40, 0.0, 1e-42], [2e-38, 0.0, 1e-38], [3.0, 1e-40, 0.5], [1e30; 3]];
    save_hdr(&Image { width: 4, height: 1, pixels: pixels.clone() }, &path).unwrap();
    let read = load_image(&path).unwrap().image.pixels;
    assert_eq!(read[0], [0.0; 3]);
    for (read, pixel) in read.iter().zip(&pixels).skip(1) {
        let largest = pixel.iter().copied().fold(0.0, f32::max);
        let off = |k: usize| (read[k] - pixel[k]).abs();
        assert!((0..3).all(|k| off(k) <= largest / 100.0), "{read:?}, not {pixel:?}");
    }
}

/// A PNG of any kind.
fn png_of(
    (width, height): (u32, u32),
    color: ::png::ColorType,
    depth: ::png::BitDepth,
    data: &[u8],
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    bytes
}

/// The levels of a PNG of red, green and blue, as the library reads them.
fn levels_of(path: &Path) -> Vec<u8> {
    let file = std::io::BufReader::new(fs::File::open(path).unwrap());
    let mut reader = ::png::Decoder::new(file).read_info().unwrap();
    assert_eq!(reader.output_color_type(), (ColorType::Rgb, BitDepth::Eight));
    let mut levels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut levels).unwrap();
    levels
}

#[test]
fn all_levels_of_a_png_survive_a_round_trip() {
    let folder = folder();
    let (first, second) = (folder.path().join("a.png"), folder.path().join("b.png"));
    let levels: Vec<u8> = (0..=255).flat_map(|v| [v, 255 - v, v / 2]).collect();
    fs::write(&first, png_of((16, 16), ColorType::Rgb, BitDepth::Eight, &levels)).unwrap();

    let loaded = load_image(&first).unwrap();
    assert!(loaded.saturates);
    save_image(&loaded.image, &second).unwrap();
    assert_eq!(levels_of(&second), levels);
}

#[test]
fn values_beyond_the_range_of_a_png_are_clamped() {
    let folder = folder();
    let path = folder.path().join("a.png");
    let image = Image { width: 1, height: 1, pixels: vec![[-1.0, 0.5, 7.0]] };
    save_png(&image, &path).unwrap();
    // 255 * (1.055 * 0.5^(1/2.4) - 0.055) = 187.52
    assert_eq!(levels_of(&path), [0, 188, 255]);
}

#[test]
fn exr_keeps_every_bit() {
    let folder = folder();
    let path = folder.path().join("a.EXR");
    let pixels = vec![[1e-30, 0.1, 1e30], [-2.5, 0.0, f32::MIN_POSITIVE]];
    let image = Image { width: 2, height: 1, pixels };
    save_image(&image, &path).unwrap();
    assert_eq!(load_image(&path).unwrap(), LoadedImage { image, saturates: false });
}

#[test]
fn a_nan_in_an_exr_is_found() {
    let folder = folder();
    let path = folder.path().join("a.exr");
    let mut image = Image::black(3, 2);
    image.pixels[4][1] = f32::NAN;
    fs::write(&path, exr_bytes(&image).unwrap()).unwrap();
    let error = error_of(&path);
    assert!(error.contains("green at column 1, row 1 is NaN"), "{error}");
}

#[test]
fn nan_is_not_written() {
    let folder = folder();
    let image = Image { width: 1, height: 1, pixels: vec![[0.0, 0.0, f32::INFINITY]] };
    for name in ["a.png", "a.exr"] {
        let error = save_image(&image, &folder.path().join(name)).unwrap_err();
        assert!(error.problem.contains("blue at column 0, row 0"), "{error}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn sixteen_bit_grey_with_alpha_is_composited_over_black() {
    let folder = folder();
    let path = folder.path().join("a.png");
    let data = [0xff, 0xff, 0x40, 0];
    let bytes = png_of((1, 1), ColorType::GrayscaleAlpha, BitDepth::Sixteen, &data);
    fs::write(&path, bytes).unwrap();
    let expected = (16384.0_f64 / 65535.0) as f32;
    assert_eq!(load_image(&path).unwrap().image.pixels, [[expected; 3]]);
}

#[test]
fn sixteen_bit_grey_is_finer_than_eight() {
    let folder = folder();
    let path = folder.path().join("a.png");
    let data = [1_u16, 30000].map(u16::to_be_bytes).concat();
    fs::write(&path, png_of((2, 1), ColorType::Grayscale, BitDepth::Sixteen, &data)).unwrap();
    let expected = [1.0 / 65535.0, 30000.0 / 65535.0].map(|v| [srgb_decode(v) as f32; 3]);
    assert_eq!(load_image(&path).unwrap().image.pixels, expected);
}

/// A PNG of `width` pixels in one row.
fn row(
    width: u32,
    color: ColorType,
    depth: BitDepth,
    palette: Option<(&[u8], &[u8])>,
    data: &[u8],
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, width, 1);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if let Some((colors, alphas)) = palette {
        encoder.set_palette(colors);
        encoder.set_trns(alphas);
    }
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    bytes
}

/// Every kind of PNG, as an image and as a texture: the colours of a texture are whole where it is
/// transparent.
#[test]
fn every_kind_of_png_is_read() {
    let half = srgb_decode(128.0 / 255.0) as f32;
    let covered = |coverage: f64| (srgb_decode(128.0 / 255.0) * coverage) as f32;
    let palette: (&[u8], &[u8]) = (&[255, 0, 0, 0, 128, 0, 128, 128, 128], &[255, 255, 51]);
    let rgba = [128, 0, 255, 51];
    let cases = [
        (row(1, ColorType::Grayscale, BitDepth::Eight, None, &[128]), [half; 3], [half; 3]),
        (row(1, ColorType::Grayscale, BitDepth::One, None, &[0x80]), [1.0; 3], [1.0; 3]),
        (row(1, ColorType::Grayscale, BitDepth::Sixteen, None, &[128, 128]), [half; 3], [half; 3]),
        (
            row(1, ColorType::GrayscaleAlpha, BitDepth::Eight, None, &[128, 51]),
            [covered(0.2); 3],
            [half; 3],
        ),
        (
            row(1, ColorType::Rgb, BitDepth::Eight, None, &[255, 0, 128]),
            [1.0, 0.0, half],
            [1.0, 0.0, half],
        ),
        (
            row(1, ColorType::Rgba, BitDepth::Eight, None, &rgba),
            [covered(0.2), 0.0, 0.2],
            [half, 0.0, 1.0],
        ),
        // Two bits are an index; of the third colour a fifth is covered.
        (
            row(1, ColorType::Indexed, BitDepth::Two, Some(palette), &[0x40]),
            [0.0, half, 0.0],
            [0.0, half, 0.0],
        ),
        (
            row(1, ColorType::Indexed, BitDepth::Two, Some(palette), &[0x80]),
            [covered(0.2); 3],
            [half; 3],
        ),
    ];
    let folder = folder();
    let path = folder.path().join("a.png");
    for (index, (bytes, image, texture)) in cases.into_iter().enumerate() {
        fs::write(&path, &bytes).unwrap();
        assert_eq!(load_image(&path).unwrap().image.pixels, [image], "{index}");
        let decoded = decode_texture(&bytes, "a.png").unwrap();
        assert_eq!(decoded.image.pixels, [texture], "{index}");
        assert_eq!(decoded.is_transparent, image != texture, "{index}");
    }
    let coverage =
        |bytes: &[u8], is_mask| decode_coverage(bytes, "a.png", is_mask).unwrap().pixels[0];
    let level = |level: f64| (level / 255.0) as f32;
    for (color, levels, alpha, mask) in [
        (ColorType::Grayscale, &[128][..], 1.0, level(128.0)),
        (ColorType::Rgb, &[255, 0, 51], 1.0, level(102.0)),
        (ColorType::Rgba, &rgba, level(51.0), level(51.0)),
        (ColorType::GrayscaleAlpha, &[128, 51], level(51.0), level(51.0)),
    ] {
        for (is_mask, expected) in [(false, alpha), (true, mask)] {
            let bytes = row(1, color, BitDepth::Eight, None, levels);
            let covered = coverage(&bytes, is_mask);
            assert!(covered.iter().all(|x| (x - expected).abs() < 1e-6), "{color:?}: {covered:?}");
        }
    }
    let bytes = row(1, ColorType::Indexed, BitDepth::Two, Some(palette), &[0x80]);
    assert_eq!(coverage(&bytes, true), [0.2; 3]);
    // An index beyond the palette.
    let bytes = row(1, ColorType::Indexed, BitDepth::Two, Some(palette), &[0xc0]);
    fs::write(&path, bytes).unwrap();
    assert_eq!(load_image(&path).unwrap().image.pixels, [[0.0; 3]]);
}

#[test]
fn jpeg_is_read() {
    let folder = folder();
    let path = folder.path().join("a.jpg");
    let encoder = || jpeg_encoder::Encoder::new_file(&path, 100).unwrap();
    encoder().encode(&[128; 64], 8, 8, jpeg_encoder::ColorType::Luma).unwrap();
    let loaded = load_image(&path).unwrap();
    assert!(loaded.saturates);
    assert!((loaded.image.pixels[9][2] - 0.2159).abs() < 0.01, "{:?}", loaded.image.pixels[9]);

    let colors: Vec<u8> = [[255, 128, 0]; 24].concat();
    let exif = b"Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0";
    let mut turned = encoder();
    turned.add_app_segment(1, exif.to_vec()).unwrap();
    turned.encode(&colors, 8, 3, jpeg_encoder::ColorType::Rgb).unwrap();
    let Image { width, height, pixels } = load_image(&path).unwrap().image;
    assert_eq!((width, height), (3, 8));
    let expected = [1.0, 0.2159, 0.0];
    assert!(pixels[5].iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.02), "{:?}", pixels[5]);
}

#[test]
fn what_is_no_image_is_refused() {
    let folder = folder();
    let file = |name: &str, bytes: &[u8]| -> PathBuf {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        path
    };
    let png = png_of((64, 64), ColorType::Rgb, BitDepth::Eight, &[0; 3 * 64 * 64]);
    assert!(error_of(&file("cut.png", &png[..png.len() / 2])).contains("cannot be decoded"));
    assert!(error_of(&file("head.png", &png[..20])).contains("cannot be decoded"));
    let mut jpeg = Vec::new();
    let noise: Vec<u8> = (0..64_u32 * 64).map(|i| (i * i / 7) as u8).collect();
    let encoder = jpeg_encoder::Encoder::new(&mut jpeg, 90);
    encoder.encode(&noise, 64, 64, jpeg_encoder::ColorType::Luma).unwrap();
    for end in [jpeg.len() / 2, jpeg.len() - 2] {
        assert!(error_of(&file("cut.jpg", &jpeg[..end])).contains("the file is cut off"));
    }
    assert!(error_of(&file("empty.png", b"")).contains("is empty"));
    assert!(error_of(&file("text.png", b"hello")).contains("is not a PNG"));
    assert!(error_of(&folder.path().join("none.png")).contains("no such file"));
    assert!(error_of(folder.path()).contains("directory"));
    let mut broken = png.clone();
    broken[40] ^= 0xff;
    assert!(error_of(&file("broken.png", &broken)).contains("cannot be decoded"));
}

#[test]
fn an_image_without_area_is_not_written() {
    let error = save_image(&Image::black(0, 3), Path::new("out.png")).unwrap_err();
    assert_eq!(error.to_string(), "out.png: 0 pixels are no image of 0 by 3");
    let short = Image { width: 2, ..Image::black(1, 1) };
    let error = save_image(&short, Path::new("out.exr")).unwrap_err();
    assert_eq!(error.to_string(), "out.exr: 1 pixels are no image of 2 by 1");
}

#[test]
fn an_unknown_extension_is_refused() {
    let error = save_image(&Image::black(1, 1), Path::new("out.bmp")).unwrap_err();
    assert!(error.to_string().starts_with("out.bmp: images are written as .png"), "{error}");
}

/// A few bytes may announce more pixels than there is memory.
#[test]
fn an_image_that_claims_to_be_huge_is_refused() {
    let folder = folder();
    let path = folder.path().join("huge.exr");
    let mut bytes = exr_bytes(&Image::black(4, 3)).unwrap();
    // Left, top, right and bottom of the pixels that there are.
    let name = b"dataWindow\0box2i\0";
    let header = bytes.windows(name.len()).position(|window| window == name).unwrap();
    let right = header + name.len() + 4 + 8;
    bytes[right..right + 4].copy_from_slice(&30_000_000_i32.to_le_bytes());
    fs::write(&path, bytes).unwrap();
    let error = error_of(&path);
    assert!(error.contains("cannot be decoded"), "{error}");
}

/// Few bytes of OpenEXR may announce a display window of any size around the data.
#[test]
fn images_larger_than_their_file_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.exr");
    save_exr(&Image { width: 2, height: 2, pixels: vec![[0.5; 3]; 4] }, &path).unwrap();
    let mut bytes = std::fs::read(&path).unwrap();
    let window = b"displayWindow\0box2i\0";
    let place = bytes.windows(window.len()).position(|at| at == window).unwrap();
    // After the length of the value come the least x and y, then the greatest x.
    let greatest = place + window.len() + 4 + 8;
    bytes[greatest..greatest + 4].copy_from_slice(&9_999_999_i32.to_le_bytes());
    std::fs::write(&path, &bytes).unwrap();
    let error = load_image(&path).unwrap_err();
    let size = bytes.len();
    let expected = format!("{size} bytes cannot hold the 10000000 x 2 pixels it has");
    assert_eq!(error.problem, expected);
}

/// A JPEG whose data ends within a code: it is read as far as it goes.
#[test]
fn jpegs_that_are_cut_short_are_read() {
    let bytes = include_bytes!("../../../../fuzz/seeds/image/cut.jpg");
    let folder = folder();
    let path = folder.path().join("a.jpg");
    fs::write(&path, bytes).unwrap();
    let image = load_image(&path).unwrap().image;
    assert_eq!((image.width, image.height), (9, 7));
}
