//! Pieces of HTML.

use serde_json::Value;

use super::chart::label;

/// Numbers of a parameter that are shown.
pub(super) const MOST_NUMBERS: usize = 12;

/// The one script: it moves the slider over the strip, and shows two images in one place.
const SCRIPT: &str = "<script>
const part = name => document.getElementById(name);
part('slider')?.addEventListener('input', event => {
  document.querySelectorAll('#strip .frame').forEach((frame, i) => {
    frame.hidden = i !== event.target.valueAsNumber;
  });
});
if (part('comparison')) {
  const [below, above] = part('comparison').querySelectorAll('img');
  below.src = part('image-target').src;
  above.src = part('image-final').src;
  part('comparison').hidden = false;
  const split = () => {
    above.style.visibility = 'visible';
    above.style.clipPath = `inset(0 0 0 ${part('split').value}%)`;
  };
  let timer;
  part('split').addEventListener('input', split);
  part('flicker').addEventListener('change', event => {
    clearInterval(timer);
    split();
    part('split').disabled = event.target.checked;
    if (event.target.checked) {
      above.style.clipPath = 'none';
      timer = setInterval(() => {
        above.style.visibility = above.style.visibility === 'hidden' ? 'visible' : 'hidden';
      }, 500);
    }
  });
  split();
}
</script>
";

/// The target, and over it the recovered image, which the script takes from those above.
pub(super) const COMPARISON: &str = "<div id=\"comparison\" hidden>
<div class=\"pair\"><img alt=\"target\"><img alt=\"recovered\"></div>
<input id=\"split\" type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"split\">
<p>Left of the split: the target; right of it: the recovered image.
<label><input id=\"flicker\" type=\"checkbox\"> one after the other</label></p>
</div>
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
#strip, #comparison { max-width: 30rem; } #slider, #split { width: 100%; max-width: 30rem; }
.pair { position: relative; } .pair img { display: block; } .pair img + img { position: absolute; inset: 0; }
.scale { display: block; height: .6rem; background: linear-gradient(to right, #000, #bcbcbc, #fff); }
.scale { background: linear-gradient(to right in srgb-linear, #000, #fff); }
.ends { display: flex; justify-content: space-between; font-size: .85rem; color: #555; }
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
         {body}{SCRIPT}</body>\n</html>\n"
    )
}

/// Figures side by side.
pub(super) fn grid(figures: &str) -> String {
    if figures.is_empty() {
        String::new()
    } else {
        format!("<div class=\"images\">\n{figures}</div>\n")
    }
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

/// A list of numbers, or what can be said of many.
pub(super) fn numbers(value: &Value) -> String {
    let Some(values) = value.as_array() else { return number(value) };
    if values.len() <= MOST_NUMBERS {
        return values.iter().map(number).collect::<Vec<_>>().join(", ");
    }
    let all = || values.iter().filter_map(Value::as_f64);
    let (low, high) = (all().min_by(f64::total_cmp), all().max_by(f64::total_cmp));
    let mean = all().sum::<f64>() / all().count() as f64;
    let [low, high, mean] = [low.unwrap_or(f64::NAN), high.unwrap_or(f64::NAN), mean].map(label);
    format!("{} numbers from {low} to {high}, mean {mean}", values.len())
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
