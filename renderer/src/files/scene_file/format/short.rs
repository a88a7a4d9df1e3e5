//! Tables that are written as one text where nothing else is to say.

use std::cell::RefCell;
use std::collections::HashMap;
use std::fmt;
use std::marker::PhantomData;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, DeserializeSeed, Deserializer, IntoDeserializer, MapAccess, Visitor};
use serde::{Deserialize, Serialize};

/// A table with a `type`, or that type alone.
pub fn name_or_table<'de, T, D>(deserializer: D) -> Result<Option<T>, D::Error>
where
    T: Deserialize<'de> + Serialize,
    D: Deserializer<'de>,
{
    text_or_table(deserializer, ["name", "type"]).map(Some)
}

/// A table, or what it has for a key alone, which is called so.
pub fn text_or_table<'de, T, D>(
    deserializer: D,
    [what, key]: [&'static str; 2],
) -> Result<T, D::Error>
where
    T: Deserialize<'de> + Serialize,
    D: Deserializer<'de>,
{
    struct TextOrTable<T> {
        what: &'static str,
        key: &'static str,
        table: PhantomData<T>,
    }

    impl<'de, T: Deserialize<'de> + Serialize> Visitor<'de> for TextOrTable<T> {
        type Value = T;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "a {} or a table with a `{}`", self.what, self.key)
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<T, E> {
            T::deserialize(HashMap::from([(self.key, text)]).into_deserializer())
        }

        fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<T, A::Error> {
            let keys = RefCell::new(Vec::new());
            let table = Keys { table, keys: &keys };
            let value = T::deserialize(MapAccessDeserializer::new(table))?;
            // Of a type without fields serde ignores all keys.
            let fields = toml::Table::try_from(&value).map_err(de::Error::custom)?;
            let unknown = keys.take().into_iter().find(|key| fields.len() == 1 && key != self.key);
            match (unknown, fields.get(self.key)) {
                (Some(unknown), Some(named)) => Err(de::Error::custom(format!(
                    "unknown field `{unknown}` of {named}, which has none"
                ))),
                _ => Ok(value),
            }
        }
    }

    deserializer.deserialize_any(TextOrTable { what, key, table: PhantomData })
}

/// A table that notes which keys are read.
struct Keys<'k, A> {
    table: A,
    keys: &'k RefCell<Vec<String>>,
}

impl<'de, A: MapAccess<'de>> MapAccess<'de> for Keys<'_, A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, A::Error> {
        let Some(key) = self.table.next_key::<String>()? else { return Ok(None) };
        self.keys.borrow_mut().push(key.clone());
        seed.deserialize(key.into_deserializer()).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        self.table.next_value_seed(seed)
    }
}
