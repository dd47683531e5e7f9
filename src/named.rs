//! Enums whose variants have names.

/// An enum in which each variant stands once, with its name: `ALL` of them in this order, and the name as `$call`.
///
/// ```text
/// named! {
///     /// A wall.
///     pub enum Wall, id {
///         /// Low x.
///         Left = "left",
///     }
/// }
/// ```
macro_rules! named {
    ($(#[$about:meta])* $seen:vis enum $kind:ident, $call:ident {
        $($(#[$doc:meta])* $variant:ident = $name:literal,)+
    }) => {
        $(#[$about])*
        $seen enum $kind { $($(#[$doc])* $variant,)+ }

        impl $kind {
            /// All of them, in their order.
            #[allow(dead_code)] // not everybody asks for all
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$variant),+];

            /// What stands for it in words and files.
            pub fn $call(self) -> &'static str {
                match self { $(Self::$variant => $name,)+ }
            }
        }
    };
}
pub(crate) use named;
