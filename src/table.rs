//! Structs beside a value of theirs.

/// A struct and a value of it, a field a line: `name: type = value;`. The value is a constant (`, const NAME`), as the
/// words of a language, or the usual one (`, Default`).
macro_rules! table {
    ($(#[$about:meta])* pub struct $table:ident, const $of:ident {
        $($(#[$doc:meta])* $field:ident: $kind:ty = $value:expr;)+
    }) => {
        $(#[$about])*
        pub struct $table { $($(#[$doc])* pub $field: $kind,)+ }

        /// The one there is so far; another is a constant like it, and the compiler asks for every field.
        pub const $of: $table = $table { $($field: $value,)+ };
    };
    ($(#[$about:meta])* pub struct $table:ident, Default {
        $($(#[$doc:meta])* $field:ident: $kind:ty = $value:expr;)+
    }) => {
        $(#[$about])*
        pub struct $table { $($(#[$doc])* pub $field: $kind,)+ }

        impl Default for $table {
            fn default() -> Self {
                Self { $($field: $value,)+ }
            }
        }
    };
}
pub(crate) use table;
