//! A file that grows record by record and knows the checksum of all it holds, so that a checkpoint
//! can say how far it had come, and a later run whether it is still that file.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};

use crc32fast::Hasher;
use serde::{Deserialize, Serialize};

/// The first part of a file: how long it is, and its checksum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Extent {
    /// Bytes.
    pub bytes: u64,
    /// CRC-32 (ISO-HDLC, that of zip and PNG) of these bytes.
    pub crc32: u32,
}

impl Extent {
    /// Whether `input` begins with this part; `None` if it is shorter.
    pub fn is_begin_of(self, input: impl Read) -> io::Result<Option<bool>> {
        let mut sum = Hasher::new();
        let mut input = input.take(self.bytes);
        let mut block = vec![0; 1 << 16];
        let mut seen = 0;
        loop {
            match input.read(&mut block)? {
                0 if seen < self.bytes => return Ok(None),
                0 => return Ok(Some(sum.finalize() == self.crc32)),
                read => {
                    sum.update(&block[..read]);
                    seen += read as u64;
                }
            }
        }
    }
}

/// A file open for appending.
pub struct GrowingFile {
    file: File,
    bytes: u64,
    sum: Hasher,
}

impl GrowingFile {
    /// An empty `file`.
    pub fn new(file: File) -> Self {
        Self { file, bytes: 0, sum: Hasher::new() }
    }

    /// `file` cut back to `extent`, its first part, to go on from there.
    pub fn cut(mut file: File, extent: Extent) -> io::Result<Self> {
        file.set_len(extent.bytes)?;
        file.seek(SeekFrom::Start(extent.bytes))?;
        let sum = Hasher::new_with_initial_len(extent.crc32, extent.bytes);
        Ok(Self { file, bytes: extent.bytes, sum })
    }

    /// What the file holds now.
    pub fn extent(&self) -> Extent {
        Extent { bytes: self.bytes, crc32: self.sum.clone().finalize() }
    }

    /// Cuts the file back to `extent`, which it once had.
    pub fn cut_back(&mut self, extent: Extent) -> io::Result<()> {
        *self = Self::cut(self.file.try_clone()?, extent)?;
        Ok(())
    }

    /// Another handle to the same file.
    pub fn handle(&self) -> io::Result<File> {
        self.file.try_clone()
    }

    /// Returns once everything is on the disk.
    pub fn sync(&self) -> io::Result<()> {
        self.file.sync_all()
    }
}

impl Write for GrowingFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.sum.update(&bytes[..written]);
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}
