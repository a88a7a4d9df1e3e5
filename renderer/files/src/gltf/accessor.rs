//! Typed views into buffers.

use super::Buffers;
use super::document::{Accessor, Document, Sparse, get};

/// So many elements an accessor may have that no bytes of a buffer stand for.
const MOST_ZEROS: usize = 1 << 24;

/// Vectors of numbers, all of them finite: positions of vertices, texture coordinates.
pub(super) fn vectors<const N: usize>(
    document: &Document,
    buffers: &Buffers,
    index: usize,
) -> Result<Vec<[f64; N]>, String> {
    let read = || {
        let accessor = get(&document.accessors, index, "accessors")?;
        let vectors: Vec<[f64; N]> = all(document, buffers, accessor)?;
        match vectors.iter().position(|v| v.iter().any(|x| !x.is_finite())) {
            Some(vertex) => Err(format!("vertex {vertex} is not finite")),
            None => Ok(vectors),
        }
    };
    read().map_err(|problem| format!("accessors[{index}]: {problem}"))
}

/// Indices of vertices.
pub(super) fn indices(
    document: &Document,
    buffers: &Buffers,
    index: usize,
) -> Result<Vec<u32>, String> {
    let read = || {
        let accessor = get(&document.accessors, index, "accessors")?;
        if accessor.normalized || !Component::of(accessor.component_type)?.is_unsigned() {
            return Err("indices must be unsigned integers".to_owned());
        }
        let indices = all(document, buffers, accessor)?;
        Ok(indices.into_iter().map(|[index]| index as u32).collect())
    };
    read().map_err(|problem| format!("accessors[{index}]: {problem}"))
}

/// The elements of an accessor: those of its bufferView, or zeros, with those in place of some that it
/// lists one by one.
fn all<const N: usize>(
    document: &Document,
    buffers: &Buffers,
    accessor: &Accessor,
) -> Result<Vec<[f64; N]>, String> {
    let &Accessor { component_type, normalized, byte_offset, count, .. } = accessor;
    let shape = if N == 1 { "SCALAR".to_owned() } else { format!("VEC{N}") };
    if accessor.shape != shape {
        return Err(format!("its type is {}, not {shape}", accessor.shape));
    }
    let component = Component::of(component_type)?;
    let read = |view: usize, byte_offset: usize, count: usize| {
        Elements::of(document, buffers, Span { view, byte_offset, count }, component, N)
    };
    let mut elements: Vec<[f64; N]> = match accessor.buffer_view {
        Some(view) => read(view, byte_offset, count)?.vectors(normalized).collect(),
        None if accessor.sparse.is_none() => return Err("has no bufferView".to_owned()),
        None if count > MOST_ZEROS => {
            return Err(format!("has {count} elements without a bufferView, above {MOST_ZEROS}"));
        }
        None => vec![[0.0; N]; count],
    };
    let Some(Sparse { count, indices, values }) = &accessor.sparse else { return Ok(elements) };
    let component = Component::of(indices.component_type)?;
    if !component.is_unsigned() {
        return Err("the indices of its sparse elements must be unsigned integers".to_owned());
    }
    let span = Span { view: indices.buffer_view, byte_offset: indices.byte_offset, count: *count };
    let places = Elements::of(document, buffers, span, component, 1)?;
    let values = read(values.buffer_view, values.byte_offset, *count)?;
    for ([place], value) in places.vectors(false).zip(values.vectors(normalized)) {
        let count = elements.len();
        let element = elements.get_mut(place as usize);
        *element.ok_or_else(|| format!("its sparse element {place} is none of {count}"))? = value;
    }
    Ok(elements)
}

#[derive(Clone, Copy)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(code: u32) -> Result<Self, String> {
        match code {
            5120 => Ok(Self::I8),
            5121 => Ok(Self::U8),
            5122 => Ok(Self::I16),
            5123 => Ok(Self::U16),
            5125 => Ok(Self::U32),
            5126 => Ok(Self::F32),
            _ => Err(format!("componentType {code} is none")),
        }
    }

    fn is_unsigned(self) -> bool {
        matches!(self, Self::U8 | Self::U16 | Self::U32)
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }
}

/// Where elements are.
struct Span {
    view: usize,
    byte_offset: usize,
    count: usize,
}

/// Elements, all of them within their buffer.
struct Elements<'a> {
    /// From the first byte of the first element to the last byte of the last.
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    component: Component,
}

impl<'a> Elements<'a> {
    fn of(
        document: &Document,
        buffers: &'a Buffers,
        Span { view, byte_offset, count }: Span,
        component: Component,
        components: usize,
    ) -> Result<Self, String> {
        let size = component.size() * components;
        let definition = get(&document.buffer_views, view, "bufferViews")?;
        let stride = definition.byte_stride.unwrap_or(size);
        if stride < size {
            return Err(format!("bufferViews[{view}]: its byteStride {stride} is below {size}"));
        }
        let view = buffers
            .view(definition)
            .map_err(|problem| format!("bufferViews[{view}]: {problem}"))?;
        let length = match count {
            0 => Some(0),
            _ => stride.checked_mul(count - 1).and_then(|length| length.checked_add(size)),
        };
        let end = length.and_then(|length| length.checked_add(byte_offset));
        let bytes = end.and_then(|end| view.get(byte_offset..end)).ok_or_else(|| {
            format!(
                "{count} elements from byte {byte_offset} on do not fit its bufferView of {} bytes",
                view.len()
            )
        })?;
        Ok(Self { bytes, stride, size, component })
    }

    fn vectors<const N: usize>(&self, normalized: bool) -> impl Iterator<Item = [f64; N]> {
        // The last element may lack the padding behind it.
        let elements = self.bytes.chunks(self.stride).map(|element| &element[..self.size]);
        elements.map(move |element| {
            std::array::from_fn(|component| self.number(element, component, normalized))
        })
    }

    /// A component of an element.
    fn number(&self, element: &[u8], i: usize, normalized: bool) -> f64 {
        let size = self.component.size();
        let bytes = &element[size * i..size * (i + 1)];
        let mut padded = [0; 4];
        padded[..size].copy_from_slice(bytes);
        let [a, b, ..] = padded;
        let (value, most) = match self.component {
            Component::I8 => (f64::from(i8::from_le_bytes([a])), 127.0),
            Component::U8 => (f64::from(a), 255.0),
            Component::I16 => (f64::from(i16::from_le_bytes([a, b])), 32767.0),
            Component::U16 => (f64::from(u16::from_le_bytes([a, b])), 65535.0),
            Component::U32 => (f64::from(u32::from_le_bytes(padded)), 4_294_967_295.0),
            Component::F32 => return f64::from(f32::from_le_bytes(padded)),
        };
        if normalized { (value / most).max(-1.0) } else { value }
    }
}
