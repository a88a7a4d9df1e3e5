//! The numbers of the objects of a scene file: the table of parameters says which there are.

use ad::Field;

use super::Problem;
use super::format::ordered::Ordered;
use super::format::value::Numbers;
use crate::scene::numbers::Numbers as NamedNumbers;
use crate::scene::table;

/// What fields were called that have other names or other units now, or are called elsewhere, by kind of object: that
/// name, and what to write.
const RENAMED: [(&str, &str, &str); 11] = [
    ("camera", "focus", "is called film_scale now"),
    (
        "light",
        "intensity",
        "is radiant_intensity (W/sr) of a point light now: a quarter of what intensity was for the \
         same picture; or power (W), π times; of a distant light it is irradiance (W/m²), π times",
    ),
    ("material", "ambient", "is called emission now"),
    ("material", "reflection", "is called mirror now"),
    ("material", "base_color", "is called diffuse"),
    ("material", "albedo", "is called diffuse"),
    ("material", "emissive", "is called emission"),
    ("mesh", "position", "is called translation"),
    ("sphere", "position", "is called center"),
    ("sphere", "translation", "of a sphere is its center"),
    ("sphere", "scale", "of a sphere is its radius"),
];

/// The names of the numbers that tables of objects of a kind may hold.
pub(super) fn names(kind: &str) -> impl Iterator<Item = &'static str> {
    table::fields(kind).filter(|name| !ARRAYS.contains(name))
}

/// Whether the numbers of objects of a kind had this name once, or have it elsewhere.
pub(super) fn was_renamed(kind: &str, name: &str) -> bool {
    RENAMED.iter().any(|(of, old, _)| (*of, *old) == (kind, name))
}

/// Sets the numbers of an object, of this kind and at this path, to those of its table.
pub(super) fn assign(
    object: &mut dyn NamedNumbers,
    kind: &str,
    path: &str,
    numbers: &Ordered<Numbers>,
) -> Result<(), Problem> {
    let fields = fields(object);
    for (key, given) in numbers {
        let place = || format!("{path}.{key}");
        let Some(field) = fields.iter().find(|field| field.name == key) else {
            let names: Vec<&str> = fields.iter().map(|field| field.name).collect();
            let renamed = RENAMED.iter().find(|(of, old, _)| (*of, *old) == (kind, key.as_str()));
            let problem = match renamed {
                Some((_, _, now)) => now.to_string(),
                None => format!("this {kind} has none; its numbers are {}", names.join(", ")),
            };
            return Err(Problem::new(place(), problem));
        };
        let numbers = match given {
            // A scale is the same along all axes if it is one number.
            Numbers::One(scale) if field.name == "scale" => vec![*scale; field.len],
            Numbers::One(number) if field.len == 1 => vec![*number],
            Numbers::Many(numbers) if numbers.len() == field.len && field.len > 1 => {
                numbers.clone()
            }
            Numbers::Many(_) if field.len == 1 => {
                return Err(Problem::new(place(), "is a number, not an array"));
            }
            Numbers::One(_) => {
                return Err(Problem::new(place(), format!("needs {} numbers, has 1", field.len)));
            }
            Numbers::Many(numbers) => {
                let problem = format!("needs {} numbers, has {}", field.len, numbers.len());
                return Err(Problem::new(place(), problem));
            }
        };
        if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
            return Err(Problem::new(place(), format!("{number} is not a finite number")));
        }
        object.set(field.name, 0, &numbers);
    }
    // What an object cannot do without is NaN until it is given.
    let is_missing = |name: &str| {
        object.get(name).is_some_and(|numbers| numbers.iter().any(|number| number.is_nan()))
    };
    match fields.iter().find(|field| is_missing(field.name)) {
        Some(field) => Err(Problem::new(
            format!("{path}.{}", field.name),
            format!("is missing; a {kind} needs one"),
        )),
        None => Ok(()),
    }
}

/// The numbers of an object, as its table holds them.
pub(super) fn of(object: &dyn NamedNumbers) -> Ordered<Numbers> {
    let entry = |field: Field| {
        let numbers = object.get(field.name)?;
        Some((field.name.to_owned(), Numbers::from(&*numbers)))
    };
    fields(object).into_iter().filter_map(entry).collect()
}

/// The fields that tables hold; arrays come from files.
fn fields(object: &dyn NamedNumbers) -> Vec<Field> {
    object.fields().into_iter().filter(|field| !ARRAYS.contains(&field.name)).collect()
}

/// The fields that are arrays.
const ARRAYS: [&str; 4] = ["vertices", "texture_coordinates", "normals", "texels"];
