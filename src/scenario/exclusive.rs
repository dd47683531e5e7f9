//! Choices that exclude each other.

/// Groups of which at most one member may be said, and what each of them says.
pub(super) const GROUPS: [(&[&str], &str); 11] = [
    (&["eta", "gamma", "restitution"], "the damping"),
    (&["nt", "dt"], "the time step"),
    (&["walls", "no_walls"], "whether there are walls"),
    (&["start", "n"], "how many discs there are"),
    (&["start", "placement"], "where the discs are"),
    (&["start", "[[disc]]"], "where the discs are"),
    (&["start", "[[population]]"], "where the discs are"),
    (&["n", "[[disc]]"], "how many discs there are"),
    (&["n", "[[population]]"], "how many discs there are"),
    (&["speed", "only [[disc]]"], "how fast the discs are (say it in velocity)"),
    (&["placement", "only [[disc]]"], "where the discs are"),
];

/// The flags that cannot stand beside that of the key `name`: those that say the same in another way.
pub(super) fn flags(name: &str) -> impl Iterator<Item = &'static str> {
    let groups = GROUPS.iter().take(3).filter(move |(group, _)| group.contains(&name));
    groups.flat_map(|(group, _)| group.iter().copied()).filter(move |other| *other != name)
}
