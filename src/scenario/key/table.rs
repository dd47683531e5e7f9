//! The macro that reads the table of keys, `keys.rs`.

/// From the table of keys: [`Settings`](super::super::settings::Settings), in which each may have been said; a
/// struct of what was chosen for each section that has a name; and the list `KEYS`.
///
/// A row is `/// help`, `name: what is said, "VALUE", allowed, "way out", { other fields of Key } => field: what is
/// held = the usual one;`. A row without a field says a part of something that is `made`, of several keys or by hand.
macro_rules! keys {
    (
        ($settings:ident, $usual:ident, $seed:ident)
        $(
            $(#[$about:meta])*
            $choices:ident {
                $($section:literal {$(
                    $(#[doc = $help:literal])*
                    $name:ident: $said:ty, $value:literal, $allowed:expr, $way_out:literal
                        $(, { $($other:ident: $is:expr),* })?
                        $(=> $field:ident: $held:ty = $otherwise:expr)?;
                )*})*
                made {$(
                    $(#[doc = $made_help:literal])*
                    $made:ident: $made_of:ty = $from:expr;
                )*}
            }
        )*
    ) => {
        /// Every choice of a run, where one was made. Flags are `--long-names`, keys the same
        /// with `_` for `-`.
        #[derive(Clone, Debug, Default, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        pub struct Settings {
            $($($($(#[doc = $help])* pub $name: Option<$said>,)*)*)*
            /// Listed discs (scenario files only).
            #[serde(rename = "disc")]
            pub discs: Vec<DiscSettings>,
            /// Groups of random discs (scenario files only).
            #[serde(rename = "population")]
            pub populations: Vec<PopulationSettings>,
        }

        /// All keys, in the order of the help.
        pub const KEYS: &[Key] = &[$($($(
            Key {
                $($($other: $is,)*)?
                ..Key {
                    name: stringify!($name),
                    help: concat!($($help),*),
                    value: $value,
                    allowed: $allowed,
                    way_out: $way_out,
                    unit: <$said as Kind>::UNIT,
                    flag: <$said as Kind>::flag,
                    section: $section,
                    ..Key::PLAIN
                }
            },
        )*)*)*];

        impl Settings {
            /// Shows `look` every key and what was said of it.
            pub(super) fn each(&self, look: &mut dyn FnMut(&'static Key, Option<&dyn Said>)) {
                let mut keys = KEYS.iter();
                let mut next = |said| keys.next().into_iter().for_each(|key| look(key, said));
                $($($(next(self.$name.as_ref().map(|said| said as &dyn Said));)*)*)*
            }

            /// These settings, and where they are silent the `other` ones.
            pub(super) fn or(self, other: Self) -> Self {
                Self {
                    $($($($name: self.$name.or(other.$name),)*)*)*
                    discs: if self.discs.is_empty() { other.discs } else { self.discs },
                    populations: if self.populations.is_empty() {
                        other.populations
                    } else {
                        self.populations
                    },
                }
            }
        }

        impl FromArgMatches for Settings {
            fn from_arg_matches(flags: &ArgMatches) -> Result<Self, clap::Error> {
                Ok(Self {
                    $($($($name: flags.get_one(stringify!($name)).cloned(),)*)*)*
                    ..Self::default()
                })
            }

            fn update_from_arg_matches(&mut self, flags: &ArgMatches) -> Result<(), clap::Error> {
                *self = Self::from_arg_matches(flags)?.or(std::mem::take(self));
                Ok(())
            }
        }

        $(
            $(#[$about])*
            #[derive(Clone, Debug, PartialEq)]
            pub struct $choices {
                $($($(
                    #[doc = concat!("As [`", stringify!($name), "`](Settings::", stringify!($name), ") says, in SI units.")]
                    pub $field: $held,
                )?)*)*
                $($(#[doc = $made_help])* pub $made: $made_of,)*
            }

            impl $choices {
                /// What was said, and where nothing was the usual.
                #[allow(unused_variables)] // not every section looks at all three
                pub(super) fn of(
                    $settings: &Settings,
                    $usual: &PresetValues,
                    $seed: u64,
                ) -> Self {
                    Self {
                        $($($($field: match &$settings.$name {
                            Some(said) => said.held().into(),
                            None => $otherwise,
                        },)?)*)*
                        $($made: $from,)*
                    }
                }

                /// Says each choice that one key says.
                pub(super) fn say(&self, settings: &mut Settings) {
                    $($($(
                        let held: Option<_> = self.$field.clone().into();
                        settings.$name = held.map(Kind::say);
                    )?)*)*
                }
            }
        )*
    };
}
pub(in crate::scenario) use keys;
