//! The one error type: what went wrong, with what, and what to do about it.

/// Everything that this crate can refuse or fail at.
///
/// Each message reads as one line: what is wrong, then the remedy.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A number, name or text from a user (URL, attribute, option) that cannot be used.
    #[error("{what}: {value:?} is not valid; {remedy}")]
    BadValue {
        /// The name of the value as the user wrote it, e.g. `wind`.
        what: String,
        /// What the user gave.
        value: String,
        /// What would be accepted.
        remedy: String,
    },
    /// Foreign bytes (tile, archive, grid) that do not hold what they should.
    #[error("{what}: {why}; {remedy}")]
    BadData {
        /// The file, URL or tile.
        what: String,
        /// What is wrong, and where.
        why: String,
        /// What to do.
        remedy: String,
    },
    /// The operating system refused a file operation.
    #[error("{what}: {source}; {remedy}")]
    Io {
        /// The file or folder.
        what: String,
        /// The system's own reason.
        source: std::io::Error,
        /// What to do.
        remedy: String,
    },
    /// A server says that there is no such file.
    #[error("{url}: the server answers {status}")]
    NotThere {
        /// What was asked for.
        url: String,
        /// Its status: 404 or 410, and what the server calls it.
        status: String,
    },
    /// A server did not deliver.
    #[error("{url}: {why}")]
    Fetch {
        /// What was asked for.
        url: String,
        /// The status or the network's reason.
        why: String,
    },
    /// The graphics device is missing or failed.
    #[error("{why}; {remedy}")]
    Gpu {
        /// What failed.
        why: String,
        /// What to do.
        remedy: String,
    },
}

/// Shorthand for results of this crate.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// Whether there is no such file, as opposed to one that cannot be had.
    pub fn is_missing(&self) -> bool {
        match self {
            Self::NotThere { .. } => true,
            Self::Io { source, .. } => source.kind() == std::io::ErrorKind::NotFound,
            _ => false,
        }
    }

    /// A [`Error::BadValue`] from anything printable.
    pub fn bad_value(what: impl Into<String>, value: impl ToString, remedy: impl Into<String>) -> Self {
        Self::BadValue { what: what.into(), value: value.to_string(), remedy: remedy.into() }
    }

    /// A [`Error::BadData`].
    pub fn bad_data(what: impl Into<String>, why: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::BadData { what: what.into(), why: why.into(), remedy: remedy.into() }
    }

    /// Wraps an [`std::io::Error`] with the file it concerns and a remedy.
    pub fn io(what: impl Into<String>, source: std::io::Error, remedy: impl Into<String>) -> Self {
        Self::Io { what: what.into(), source, remedy: remedy.into() }
    }

    /// A [`Error::Gpu`].
    pub fn gpu(why: impl ToString, remedy: impl Into<String>) -> Self {
        Self::Gpu { why: why.to_string(), remedy: remedy.into() }
    }
}
