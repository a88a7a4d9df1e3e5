//! Typed views into buffers.

use super::Buffers;
use super::document::{Accessor, Document, get};

/// Vectors of numbers, all of them finite: positions of vertices, texture coordinates.
pub(super) fn vectors<const N: usize>(
    document: &Document,
    buffers: &Buffers,
    index: usize,
) -> Result<Vec<[f64; N]>, String> {
    let read = || {
        let elements = Elements::of(document, buffers, index, N)?;
        let vector = |element: &[u8]| std::array::from_fn(|i| elements.number(element, i));
        let vectors: Vec<[f64; N]> = elements.iter().map(vector).collect();
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
        let elements = Elements::of(document, buffers, index, 1)?;
        match elements.component {
            Component::U8 | Component::U16 | Component::U32 if !elements.normalized => {
                Ok(elements.iter().map(|element| elements.number(element, 0) as u32).collect())
            }
            _ => Err("indices must be unsigned integers".to_owned()),
        }
    };
    read().map_err(|problem| format!("accessors[{index}]: {problem}"))
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

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }
}

/// The elements of an accessor, all of them within their buffer.
struct Elements<'a> {
    /// From the first byte of the first element to the last byte of the last.
    bytes: &'a [u8],
    stride: usize,
    size: usize,
    component: Component,
    normalized: bool,
}

impl<'a> Elements<'a> {
    fn of(
        document: &Document,
        buffers: &'a Buffers,
        index: usize,
        components: usize,
    ) -> Result<Self, String> {
        let accessor = get(&document.accessors, index, "accessors")?;
        let &Accessor { component_type, normalized, byte_offset, count, .. } = accessor;
        let shape = if components == 1 { "SCALAR".to_owned() } else { format!("VEC{components}") };
        if accessor.shape != shape {
            return Err(format!("its type is {}, not {shape}", accessor.shape));
        }
        let (Some(view), None) = (accessor.buffer_view, &accessor.sparse) else {
            return Err("sparse accessors and those without a bufferView are not read".to_owned());
        };
        let component = Component::of(component_type)?;
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
        Ok(Self { bytes, stride, size, component, normalized })
    }

    fn iter(&self) -> impl Iterator<Item = &'a [u8]> {
        // The last element may lack the padding behind it.
        self.bytes.chunks(self.stride).map(|element| &element[..self.size])
    }

    /// A component of an element.
    fn number(&self, element: &[u8], i: usize) -> f64 {
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
        if self.normalized { (value / most).max(-1.0) } else { value }
    }
}
