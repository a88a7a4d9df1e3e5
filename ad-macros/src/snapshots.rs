//! What the attribute writes, as a reader of `cargo expand` sees it.
//!
//! Each file `snapshots/NAME.rs` holds a function; `snapshots/NAME.expanded.rs` its `vjp` and
//! `vjp_onto`, `snapshots/NAME.forward.rs` its `jvp`. With the environment variable
//! `UPDATE_SNAPSHOTS` set the test writes the latter two anew.

use std::path::Path;

use syn::{File, ImplItem, Item};

/// The generated function `name` for the function in `source`, formatted.
fn expanded(source: &str, name: &str) -> String {
    let function: Item = syn::parse_str(source).expect("the snapshot is a function");
    let tokens = crate::attribute::expand(quote::quote!(), quote::quote!(#function));
    let mut file: File = syn::parse2(tokens).expect("the expansion is items");
    file.items.retain_mut(|item| match item {
        Item::Impl(block) => {
            block.items.retain_mut(|item| match item {
                ImplItem::Fn(function) => {
                    function.attrs.clear();
                    // One of `vjp` and `vjp_onto` has the sweeps in it.
                    function.sig.ident == name
                        || (name == "vjp" && function.sig.ident == "vjp_onto")
                }
                _ => false,
            });
            true
        }
        _ => false,
    });
    prettyplease::unparse(&file)
}

#[test]
fn expansions_are_as_reviewed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/snapshots");
    let mut count = 0;
    for entry in std::fs::read_dir(&folder).expect("the folder of snapshots") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        if name.contains('.') {
            continue;
        }
        let source = std::fs::read_to_string(&path).expect("a readable snapshot");
        for (function, ending) in [("vjp", "expanded"), ("jvp", "forward")] {
            let actual = expanded(&source, function);
            let expected = folder.join(format!("{name}.{ending}.rs"));
            if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
                std::fs::write(&expected, &actual).expect("a writable snapshot");
            }
            let expected = std::fs::read_to_string(&expected).unwrap_or_default();
            assert_eq!(actual, expected, "{function} of {name}");
        }
        count += 1;
    }
    assert!(count > 0);
}
