//! The macro that makes of one list of columns all that is done with them.

/// Two structs of the same columns, one that owns them and one that looks at them where they lie: of `one` row, of
/// a row for `each` disc as it is stored (or none at all), and of a length of their `own`. From the list follow
/// copies, the arrays of a checkpoint and their reading, and what goes along when discs are stored in another order.
macro_rules! columns {
    (
        $(#[$about:meta])* $name:ident, $(#[$about_view:meta])* $view:ident;
        one { $($(#[$doc_one:meta])* $one:ident: $One:ty,)* }
        each { $($(#[$doc_each:meta])* $each:ident: $Each:ty,)* }
        own { $($(#[$doc_own:meta])* $own:ident: $Own:ty,)* }
    ) => {
        $(#[$about])*
        #[derive(Clone, Default)]
        pub struct $name {
            $($(#[$doc_one])* pub $one: $One,)*
            $($(#[$doc_each])* pub $each: Vec<$Each>,)*
            $($(#[$doc_own])* pub $own: Vec<$Own>,)*
        }

        $(#[$about_view])*
        #[derive(Clone, Copy)]
        pub struct $view<'a> {
            $($(#[$doc_one])* pub $one: $One,)*
            $($(#[$doc_each])* pub $each: &'a [$Each],)*
            $($(#[$doc_own])* pub $own: &'a [$Own],)*
        }

        impl $name {
            /// The same, looked at where they lie.
            pub fn view(&self) -> $view<'_> {
                $view {
                    $($one: self.$one,)*
                    $($each: &self.$each,)*
                    $($own: &self.$own,)*
                }
            }

            /// Becomes a copy of `from`, in the room that is there already; columns named in `but` stay as they are.
            pub fn copy_from(&mut self, from: $view, but: &[&str]) {
                $(if !but.contains(&stringify!($one)) { self.$one = from.$one; })*
                $(if !but.contains(&stringify!($each)) { copy(&mut self.$each, from.$each); })*
                $(if !but.contains(&stringify!($own)) { copy(&mut self.$own, from.$own); })*
            }

            /// Exchanges what lies beside the discs stored at `a` and `b`.
            pub fn swap(&mut self, a: usize, b: usize) {
                $(if !self.$each.is_empty() { self.$each.swap(a, b); })*
            }

            /// The columns that `arrays` have of `n` discs, taken out of them.
            ///
            /// # Errors
            ///
            /// Names the array that is missing or does not fit.
            pub fn from_arrays(
                n: usize,
                arrays: &mut Vec<(String, Array)>,
            ) -> Result<Self, String> {
                let mut columns = Self::default();
                $(columns.$one = rows(arrays, stringify!($one), Some(1))?[0];)*
                $(if has(arrays, stringify!($each)) {
                    columns.$each = rows(arrays, stringify!($each), Some(n))?;
                })*
                $(if has(arrays, stringify!($own)) {
                    columns.$own = rows(arrays, stringify!($own), None)?;
                })*
                Ok(columns)
            }
        }

        impl<'a> $view<'a> {
            /// All that are there, by name.
            pub fn arrays(self) -> Vec<(&'static str, ArrayView<'a>)> {
                let mut arrays = vec![
                    $((stringify!($one), ArrayView::of_rows([self.$one].into_iter())),)*
                    $((stringify!($each), ArrayView::of_rows(self.$each.iter().copied())),)*
                    $((stringify!($own), ArrayView::of_rows(self.$own.iter().copied())),)*
                ];
                arrays.retain(|(_, array)| !array.is_empty());
                arrays
            }
        }
    };
}
pub(super) use columns;
