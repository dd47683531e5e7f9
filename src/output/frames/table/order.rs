//! The order of the rows of a table: frame by frame, each disc once in a frame.

use super::Table;
use crate::output::frames::column::Column;
use crate::output::frames::frame::Row;

impl Table {
    /// The column that counts the frames must not go back: rows sorted by disc would be frames of one disc each.
    pub(super) fn check_order(&mut self, row: &Row) -> Result<(), String> {
        let counted = |row: &Row| {
            let columns = [("frame", row.frame), ("step", row.step), ("time_s", row.time)];
            columns.into_iter().find_map(|(name, value)| Some((name, value?)))
        };
        let before = self.last.as_ref().and_then(counted);
        match (before, counted(row)) {
            (Some((_, before)), Some((name, now))) if now < before => {
                self.goes_back = true;
                Err(format!(
                    "{name} {now} comes after {name} {before}\n  way out: sort the rows by {name}"
                ))
            }
            _ => Ok(()),
        }
    }

    /// No two discs of a frame have one id.
    pub(super) fn check_id(&mut self, row: &Row) -> Result<(), String> {
        let Some(id) = row.disc.id.filter(|id| !self.ids.add(*id)) else { return Ok(()) };
        let names_frames = row.frame.or(row.step).or(row.time).is_some();
        let layout = self.layout.as_ref().map(|layout| layout.without(Column::Id));
        let columns = layout.map(|layout| layout.to_string()).unwrap_or_default();
        let (why, way_out) = match names_frames {
            true => ("", "give each disc a number of its own"),
            false => (
                "; probably these are several frames, without a column that tells them apart",
                "a column frame, step or time_s",
            ),
        };
        Err(format!(
            "id {id} comes twice in one frame{why}\n  way out: {way_out}; or, if it is no id, --columns {columns}"
        ))
    }
}
