//! How much memory there is for this process: Linux tells it in files; elsewhere nobody does.

use std::fs;
use std::path::Path;

/// Memory that can still be taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::cli) struct Room {
    /// Bytes.
    pub bytes: u64,
    /// Who sets the limit.
    pub whose: &'static str,
}

/// The least of what the machine, the control groups and the limits of this process leave. `None` where the system does
/// not tell.
pub(in crate::cli) fn room() -> Option<Room> {
    let text = |path: &str| fs::read_to_string(path).unwrap_or_default();
    let groups = groups_in(&text("/proc/self/cgroup")).into_iter().filter_map(|group| group.left());
    let rooms = [
        (free_in(&text("/proc/meminfo")), "free on this machine"),
        (groups.min(), "left by the control group of this process"),
        (
            address_space_in(&text("/proc/self/limits"), &text("/proc/self/statm")),
            "left by the limit of this process: ulimit -v",
        ),
    ];
    let rooms = rooms.into_iter().filter_map(|(bytes, whose)| Some(Room { bytes: bytes?, whose }));
    rooms.min_by_key(|room| room.bytes)
}

/// Memory that can be had, and swap, from the text of `/proc/meminfo`; units of 1024 bytes (proc_meminfo(5)).
fn free_in(meminfo: &str) -> Option<u64> {
    let kilobytes = |name: &str| -> Option<u64> {
        let line = meminfo.lines().find_map(|line| line.strip_prefix(name))?;
        line.trim().strip_suffix("kB")?.trim_end().parse().ok()
    };
    let swap = kilobytes("SwapFree:").unwrap_or(0);
    Some(1024 * kilobytes("MemAvailable:")?.saturating_add(swap))
}

/// What `ulimit -v` leaves, from the texts of `/proc/self/limits`, bytes, and of `/proc/self/statm`, of which the first
/// number is the pages that are mapped (proc_pid_statm(5)).
fn address_space_in(limits: &str, statm: &str) -> Option<u64> {
    // Of all sizes of pages the smallest: rather too little is taken for used than a possible run refused.
    const PAGE: u64 = 4096;
    // The allocator keeps 64 MiB of addresses for each thread, as long as there are any: for the one that listens to
    // signals, the one that writes out.txt, and a helper.
    const RESERVED: u64 = 200_000_000;
    let line = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let most: u64 = line.split_whitespace().next()?.parse().ok()?; // or "unlimited"
    let pages: u64 = statm.split_whitespace().next()?.parse().ok()?;
    let left = most.saturating_sub(PAGE.saturating_mul(pages));
    Some(left - RESERVED.min(left / 2))
}

/// A control group that counts memory: its folder, and what its files are called there.
#[derive(Debug, PartialEq, Eq)]
struct Group {
    folder: String,
    most: &'static str,
    used: &'static str,
}

impl Group {
    /// Bytes that it leaves, if it limits them.
    fn left(&self) -> Option<u64> {
        let read = |name: &str| fs::read_to_string(Path::new(&self.folder).join(name)).ok();
        let number = |name: &str| read(name)?.trim().parse::<u64>().ok(); // or "max"
        // Files that it holds in memory it can do without.
        let cached = read("memory.stat").and_then(|stat| inactive_in(&stat)).unwrap_or(0);
        let used = number(self.used)?.saturating_sub(cached);
        Some(number(self.most)?.saturating_sub(used))
    }
}

/// Memory of files that were not used of late, from the text of a `memory.stat`, bytes.
fn inactive_in(stat: &str) -> Option<u64> {
    let names = ["total_inactive_file ", "inactive_file "];
    names
        .iter()
        .find_map(|name| stat.lines().find_map(|line| line.strip_prefix(name)))?
        .parse()
        .ok()
}

/// The groups of this process and those above them, from the text of `/proc/self/cgroup` (cgroups(7)).
fn groups_in(cgroup: &str) -> Vec<Group> {
    let groups = cgroup.lines().filter_map(|line| {
        let mut parts = line.splitn(3, ':');
        let (_, kinds, path) = (parts.next()?, parts.next()?, parts.next()?);
        let is_memory = kinds.split(',').any(|kind| kind == "memory");
        let (root, most, used) = match kinds.is_empty() {
            true => ("/sys/fs/cgroup", "memory.max", "memory.current"),
            false if is_memory => {
                ("/sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes")
            }
            false => return None,
        };
        let above = Path::new(path).ancestors().map(move |path| {
            let folder = format!("{root}{}", path.to_string_lossy().trim_end_matches('/'));
            Group { folder, most, used }
        });
        Some(above.collect::<Vec<_>>())
    });
    groups.flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_free_is_memory_and_swap_in_units_of_1024_bytes() {
        let text =
            "MemTotal:  9999 kB\nMemFree: 1 kB\nMemAvailable:   3000 kB\nSwapFree:  500 kB\n";
        assert_eq!(free_in(text), Some(3_584_000));
        assert_eq!(free_in("MemAvailable:   3000 kB\n"), Some(3_072_000));
        for nothing in ["", "MemFree: 1 kB\n", "MemAvailable: many kB\n"] {
            assert_eq!(free_in(nothing), None);
        }
    }

    #[test]
    fn a_limit_on_the_address_space_leaves_what_is_not_mapped() {
        let limits = "Limit  Soft Limit Hard Limit Units\nMax data size unlimited unlimited bytes\n\
                      Max address space         8192000              unlimited            bytes\n";
        assert_eq!(address_space_in(limits, "1000 500 30 1 0 2 0"), Some(2_048_000));
        let large = limits.replace("8192000", "1004096000");
        assert_eq!(address_space_in(&large, "1000 500"), Some(800_000_000));
        assert_eq!(address_space_in(limits, "1000000 500 30 1 0 2 0"), Some(0));
        assert_eq!(address_space_in(&limits.replace("8192000", "unlimited"), "1000 5"), None);
    }

    #[test]
    fn groups_are_found_with_all_above_them_in_both_versions() {
        let folders = |text: &str| -> Vec<String> {
            groups_in(text)
                .into_iter()
                .map(|group| format!("{}/{}", group.folder, group.most))
                .collect()
        };
        assert_eq!(
            folders("0::/user.slice/a.scope\n"),
            [
                "/sys/fs/cgroup/user.slice/a.scope/memory.max",
                "/sys/fs/cgroup/user.slice/memory.max",
                "/sys/fs/cgroup/memory.max"
            ]
        );
        assert_eq!(
            folders("5:cpu,cpuacct:/a\n4:memory:/lab\n"),
            [
                "/sys/fs/cgroup/memory/lab/memory.limit_in_bytes",
                "/sys/fs/cgroup/memory/memory.limit_in_bytes"
            ]
        );
        assert_eq!(folders(""), [""; 0]);
    }

    #[test]
    fn a_group_leaves_its_limit_without_what_it_uses_and_cannot_do_without() {
        let folder = tempfile::tempdir().unwrap();
        let group = Group {
            folder: folder.path().to_string_lossy().into_owned(),
            most: "memory.max",
            used: "memory.current",
        };
        let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
        write("memory.max", "max\n");
        write("memory.current", "300\n");
        assert_eq!(group.left(), None);
        write("memory.max", "1000\n");
        assert_eq!(group.left(), Some(700));
        write("memory.stat", "anon 7\ninactive_file 100\nactive_file 5\n");
        assert_eq!(group.left(), Some(800));
        write("memory.stat", "inactive_file 1\ntotal_inactive_file 200\n");
        assert_eq!(group.left(), Some(900));
    }
}
