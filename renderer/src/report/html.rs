//! Pieces of HTML.

use serde_json::Value;

use super::chart::label;

/// Numbers of a parameter that are shown.
const MOST_NUMBERS: usize = 12;

/// The script of the slider over the strip.
pub(super) const SLIDER: &str = "<script>
const frames = document.querySelectorAll('#strip .frame');
document.getElementById('slider').addEventListener('input', event => {
  frames.forEach((frame, i) => { frame.hidden = i !== event.target.valueAsNumber; });
});
</script>
";

const STYLE: &str = "
:root { color-scheme: light; font: 15px/1.45 system-ui, sans-serif; color: #222; background: #fff; }
body { max-width: 64rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.1rem; margin: 2rem 0 .6rem; }
table { border-collapse: collapse; } th, td { padding: .2rem .9rem .2rem 0; text-align: left; vertical-align: top; }
tr { border-bottom: 1px solid #e4e4e4; } th { font-weight: 600; } td { font-variant-numeric: tabular-nums; }
figure { margin: 0; } figcaption { color: #555; font-size: .85rem; }
.images { display: grid; grid-template-columns: repeat(auto-fit, minmax(13rem, 1fr)); gap: 1rem; }
img { width: 100%; height: auto; image-rendering: pixelated; background: #000; }
#strip { max-width: 30rem; } #slider { width: 100%; max-width: 30rem; }
section > svg { width: 100%; max-width: 50rem; height: auto; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(18rem, 1fr)); gap: 1rem; }
.charts svg { width: 100%; height: auto; font-size: 11px; }
.charts .title { font-weight: 600; } .charts .y, .charts .x { fill: #555; text-anchor: end; }
.axes { fill: none; stroke: #ccc; } .curve { fill: none; stroke: #1f77b4; stroke-width: 1.6; }
.truth { stroke: #d62728; stroke-dasharray: 5 4; }
pre { overflow-x: auto; background: #f6f6f6; padding: .8rem; }
";

/// The whole page; `title` and `body` are HTML.
pub(super) fn page(title: &str, body: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n\
         {body}</body>\n</html>\n"
    )
}

/// Text as it stands in HTML and in its attributes.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            c => escaped.push(c),
        }
    }
    escaped
}

/// A number, or nothing if it is none.
pub(super) fn number(value: &Value) -> String {
    value.as_f64().map(label).unwrap_or_default()
}

/// A list of numbers, or as much of it as can be read.
pub(super) fn numbers(value: &Value) -> String {
    let Some(values) = value.as_array() else { return number(value) };
    let shown: Vec<String> = values.iter().take(MOST_NUMBERS).map(number).collect();
    match values.len().saturating_sub(MOST_NUMBERS) {
        0 => shown.join(", "),
        more => format!("{}, and {more} more", shown.join(", ")),
    }
}

/// A PNG as the address of an image (base64, RFC 4648).
pub(super) fn data_uri(png: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut uri = String::from("data:image/png;base64,");
    for group in png.chunks(3) {
        let byte = |i: usize| u32::from(group.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for i in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * i) & 63) as usize];
            uri.push(if i <= group.len() { char::from(digit) } else { '=' });
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_are_base64() {
        // The test vectors of RFC 4648.
        for (bytes, text) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v")] {
            assert_eq!(data_uri(bytes.as_bytes()), format!("data:image/png;base64,{text}"));
        }
        assert_eq!(data_uri(&[0xfb, 0xff, 0xbf]), "data:image/png;base64,+/+/");
    }

    #[test]
    fn text_cannot_become_markup() {
        assert_eq!(escape("<a b='\"&'>"), "&lt;a b=&#39;&quot;&amp;&#39;&gt;");
    }
}
