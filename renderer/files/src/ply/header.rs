//! The header of a PLY file: what stands in the data, and how.

use renderer_core::Error;

use super::source::{Format, Kind, Scalar, Source};
use crate::warning::Warnings;

pub(super) struct Header {
    /// The elements, in the order of the data.
    pub elements: Vec<Element>,
    /// The count of the element `vertex`.
    pub vertices: u64,
}

pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
}

pub(super) struct Property {
    pub name: String,
    pub kind: Kind,
}

/// Names of texture coordinates, the ones that programs write.
const TEXTURE_NAMES: [[&str; 2]; 4] =
    [["u", "v"], ["s", "t"], ["texture_u", "texture_v"], ["texture_s", "texture_t"]];

impl Element {
    /// The names of its texture coordinates, if it has some.
    pub fn texture_names(&self) -> Option<[&'static str; 2]> {
        TEXTURE_NAMES.into_iter().find(|names| self.has(names))
    }

    /// The names of its normal, if it has one.
    pub fn normal_names(&self) -> Option<[&'static str; 3]> {
        Some(["nx", "ny", "nz"]).filter(|names| self.has(names))
    }

    /// Whether it has numbers of all these names.
    fn has(&self, names: &[&str]) -> bool {
        names.iter().all(|name| {
            let mut properties = self.properties.iter();
            properties.any(|p| p.name == *name && matches!(p.kind, Kind::Scalar(_)))
        })
    }
}

/// What is said of a property that would change the image, and is left out.
fn left_out(element: &str, property: &str) -> Option<&'static str> {
    match (element, property) {
        ("face", "texcoord") => Some("texture coordinates of faces are left out"),
        ("vertex" | "face", "red" | "diffuse_red") => Some("colours are left out"),
        _ => None,
    }
}

/// The elements that surfaces are made of: polygons, and strips of triangles.
const SURFACES: [&str; 2] = ["face", "tristrips"];

/// Whether a property of a face is the list of its corners.
pub(super) fn is_corner_list(property: &Property) -> bool {
    let named = matches!(property.name.as_str(), "vertex_indices" | "vertex_index");
    named && matches!(property.kind, Kind::List { .. })
}

/// Reads the header; the data follows it.
pub(super) fn read<'a>(
    bytes: &'a [u8],
    place: &str,
    warnings: &mut Warnings,
) -> Result<(Header, Source<'a>), Error> {
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    let mut rest = bytes;
    let mut line_number = 0;
    let mut format = None;
    let mut elements: Vec<Element> = Vec::new();
    loop {
        let Some(end) = rest.iter().position(|&byte| byte == b'\n') else {
            let problem = if line_number == 0 {
                "is no PLY file: its first line is not `ply`"
            } else {
                "ends within the header; `end_header` is missing"
            };
            return Err(Error::new(place, problem));
        };
        let line = String::from_utf8_lossy(&rest[..end]);
        rest = &rest[end + 1..];
        line_number += 1;
        let refuse = |problem: String| Error::new(format!("{place}:{line_number}"), problem);
        let words: Vec<&str> = line.split_whitespace().collect();
        let mut warn = |problem: &str| {
            warnings.add(problem, format_args!("{place}:{line_number}"), problem);
        };
        match words[..] {
            ["ply"] if line_number == 1 => {}
            _ if line_number == 1 => {
                return Err(Error::new(place, "is no PLY file: its first line is not `ply`"));
            }
            ["comment", "TextureFile", ..] => {
                warn("the texture is left out; a material of a scene file may have one");
            }
            [] | ["comment" | "obj_info", ..] => {}
            ["format", name, "1.0"] => format = Some(Format::named(name).map_err(refuse)?),
            ["element", name, count] => {
                let count = count
                    .parse()
                    .map_err(|_| refuse(format!("the count of {name} is `{count}`")))?;
                if elements.iter().any(|element| element.name == name) {
                    return Err(refuse(format!("the element {name} is defined twice")));
                }
                if count > 0 && name != "vertex" && !SURFACES.contains(&name) {
                    warn(&format!("the element {name} is left out"));
                }
                elements.push(Element { name: name.to_owned(), count, properties: Vec::new() });
            }
            ["property", ref words @ ..] => {
                let property = property(words).map_err(refuse)?;
                let element = elements.last_mut();
                let element = element
                    .ok_or_else(|| refuse("a property stands before any element".to_owned()))?;
                if let Some(problem) = left_out(&element.name, &property.name) {
                    warn(problem);
                }
                element.properties.push(property);
            }
            ["end_header"] => break,
            _ => return Err(refuse(format!("`{}` is no line of a header", line.trim()))),
        }
    }
    let format = format.ok_or_else(|| Error::new(place, "names no format; `format` is missing"))?;
    let header = check(elements).map_err(|problem| Error::new(place, problem))?;
    Ok((header, Source::new(rest, format, line_number)))
}

fn property(words: &[&str]) -> Result<Property, String> {
    let (name, kind) = match words {
        ["list", count, item, name] => {
            let (count, item) = (Scalar::named(count)?, Scalar::named(item)?);
            if !count.is_integer() {
                return Err(format!("the count of the list {name} is no integer"));
            }
            (name, Kind::List { count, item })
        }
        [scalar, name] => (name, Kind::Scalar(Scalar::named(scalar)?)),
        _ => return Err("a property is a type and a name, or `list` with two types".to_owned()),
    };
    Ok(Property { name: (*name).to_owned(), kind })
}

/// Whether the elements are those of a mesh.
fn check(elements: Vec<Element>) -> Result<Header, String> {
    let find = |name: &str| elements.iter().find(|element| element.name == name);
    let vertex = find("vertex").ok_or("has no element vertex")?;
    for axis in ["x", "y", "z"] {
        let is_axis = |p: &&Property| p.name == axis && matches!(p.kind, Kind::Scalar(_));
        match vertex.properties.iter().filter(is_axis).count() {
            1 => {}
            0 => return Err(format!("its vertices have no property {axis}")),
            _ => return Err(format!("its vertices have the property {axis} twice")),
        }
    }
    let surfaces: Vec<&Element> = SURFACES.iter().filter_map(|name| find(name)).collect();
    if surfaces.is_empty() {
        return Err("has no element face or tristrips; a mesh needs one".to_owned());
    }
    for Element { name, properties, .. } in surfaces {
        match properties.iter().filter(|property| is_corner_list(property)).count() {
            1 => {}
            0 => return Err(format!("its element {name} has no list vertex_indices")),
            _ => return Err(format!("its element {name} has the list vertex_indices twice")),
        }
    }
    let vertices = vertex.count;
    Ok(Header { elements, vertices })
}
