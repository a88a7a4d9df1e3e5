//! Faces of an OBJ file.

use super::statements::words;
use crate::meshes::FileNormals;

/// How many elements the file has defined so far.
#[derive(Default)]
pub(super) struct Counts {
    pub vertices: u32,
    pub texture_coordinates: u32,
    pub normals: u32,
}

/// What a corner of a face has beside its vertex.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub is_textured: bool,
    pub has_normal: bool,
}

/// Checks what follows `f`: for each corner vertex, texture coordinates and normal. Appends the face to
/// `text`, without normals if these are not wanted, and to `corners` what each corner has.
pub(super) fn prepare_face(
    rest: &str,
    counts: &Counts,
    normals: FileNormals,
    text: &mut String,
    corners: &mut Vec<Corner>,
) -> Result<(), String> {
    let kinds = [
        ("vertex", counts.vertices),
        ("texture coordinate", counts.texture_coordinates),
        ("normal", counts.normals),
    ];
    let first = corners.len();
    text.push('f');
    for corner in words(rest) {
        let mut parts = corner.split('/');
        let [vertex, texture, normal] = [(); 3].map(|()| parts.next().unwrap_or(""));
        if parts.next().is_some() {
            return Err(format!("`{corner}` is not vertex/texture/normal"));
        }
        check_index(vertex, kinds[0])?;
        text.extend([" ", vertex]);
        // Only the vertex has to be there.
        if !texture.is_empty() {
            check_index(texture, kinds[1])?;
            text.extend(["/", texture]);
        }
        // Files often name normals that were left out of them; only who wants them needs them.
        let has_normal = !normal.is_empty() && normals == FileNormals::Read;
        if has_normal {
            check_index(normal, kinds[2])?;
        }
        if has_normal {
            text.extend([if texture.is_empty() { "//" } else { "/" }, normal]);
        }
        corners.push(Corner { is_textured: !texture.is_empty(), has_normal });
    }
    text.push('\n');
    match corners.len() - first {
        count @ 0..3 => Err(format!("a face has at least 3 vertices, this one {count}")),
        _ => Ok(()),
    }
}

/// An index counts from 1, or from the end as -1, -2, ...
fn check_index(word: &str, (kind, count): (&str, u32)) -> Result<(), String> {
    let Ok(value) = word.parse::<i64>() else {
        return Err(format!("`{word}` is not the index of a {kind}"));
    };
    if value == 0 || value.unsigned_abs() > u64::from(count) {
        let problem =
            format!("{kind} {value} is out of range: {count} are defined before this line");
        return Err(problem);
    }
    Ok(())
}
