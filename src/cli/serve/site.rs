//! The folder that is served: which file a request means, and what to say about it.

use crate::error::{Error, Result};
use jiff::Timestamp;
use jiff::fmt::rfc2822;
use std::fs::{File, Metadata};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// A folder of files, with nothing outside it.
#[derive(Debug, Clone)]
pub struct Site {
    root: PathBuf,
}

/// A file of the site, open, with what its headers say.
#[derive(Debug)]
pub struct Found {
    /// The open file, at its start.
    pub file: File,
    /// Bytes.
    pub len: u64,
    /// `Content-Type`.
    pub mime: &'static str,
    /// Strong validator: changes with the length or the time of the last write (in nanoseconds).
    pub etag: String,
    /// When it was last written, where the file system knows.
    pub modified: Option<Timestamp>,
    /// `Cache-Control`.
    pub cache: &'static str,
}

impl Site {
    /// Opens `dir`; it must be a folder that holds the page.
    ///
    /// # Errors
    /// [`Error::Io`] when the folder is not there, [`Error::BadValue`] when it holds no `index.html`.
    pub fn open(dir: &Path) -> Result<Self> {
        let build = "build the page with `make build`, or name the folder that holds it";
        let root = dir.canonicalize().map_err(|source| Error::io(dir.display().to_string(), source, build))?;
        if !root.join("index.html").is_file() {
            return Err(Error::bad_value("folder to serve", dir.display(), format!("it has no index.html: {build}")));
        }
        Ok(Self { root })
    }

    /// The file for the target of a request (`/data/water.pmtiles?x=1`), or `None` for whatever is not to be served.
    ///
    /// Nothing outside the folder is, by `..`, by an escape or by a symbolic link; nor are hidden files and folder listings.
    #[must_use]
    pub fn find(&self, target: &str) -> Option<Found> {
        let path = self.root.join(relative_path(target)?).canonicalize().ok()?;
        if !path.starts_with(&self.root) {
            return None;
        }
        let file = File::open(&path).ok()?;
        let meta = file.metadata().ok().filter(Metadata::is_file)?;
        let written = meta.modified().ok();
        let nanoseconds = written.and_then(|t| t.duration_since(UNIX_EPOCH).ok()).map_or(0, |d| d.as_nanos());
        let name = path.file_name()?.to_str()?;
        Some(Found {
            len: meta.len(),
            mime: mime(name),
            etag: format!("\"{:x}-{nanoseconds:x}\"", meta.len()),
            modified: written.and_then(|t| Timestamp::try_from(t).ok()),
            cache: if has_hash(name) { "public, max-age=31536000, immutable" } else { "no-cache" },
            file,
        })
    }
}

/// The decoded path below the root, `index.html` for a folder; `None` where it is not plain.
fn relative_path(target: &str) -> Option<PathBuf> {
    let path = percent_decode(target.split(['?', '#']).next()?.strip_prefix('/')?)?;
    let folder = path.is_empty() || path.ends_with('/');
    let mut parts: Vec<&str> = path.trim_end_matches('/').split('/').filter(|part| !part.is_empty()).collect();
    if folder {
        parts.push("index.html");
    }
    // A leading dot is `.`, `..` or a hidden file; the others separate or name drives on some systems.
    let plain = |part: &&str| !part.starts_with('.') && !part.contains(['\0', '\\', ':']);
    parts.iter().all(plain).then(|| parts.iter().collect())
}

fn percent_decode(text: &str) -> Option<String> {
    let hex = |b: Option<u8>| b.and_then(|b| char::from(b).to_digit(16)).and_then(|d| u8::try_from(d).ok());
    let mut bytes = text.bytes();
    let mut out = Vec::with_capacity(text.len());
    while let Some(byte) = bytes.next() {
        out.push(if byte == b'%' { hex(bytes.next())? * 16 + hex(bytes.next())? } else { byte });
    }
    String::from_utf8(out).ok()
}

/// True when the file's name carries a hash of its content, as Trunk writes it: `name-0123456789abcdef_bg.wasm`.
fn has_hash(name: &str) -> bool {
    name.split(['-', '_', '.']).any(|part| part.len() >= 15 && part.bytes().all(|b| b.is_ascii_hexdigit()))
}

/// A browser compiles WebAssembly while it loads only when the type says so.
fn mime(name: &str) -> &'static str {
    match name.rsplit_once('.').map_or("", |(_, extension)| extension) {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" | "map" => "application/json",
        "wasm" => "application/wasm",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "jpg" | "jpeg" => "image/jpeg",
        "webp" => "image/webp",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "txt" | "md" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

/// A time as HTTP writes it (RFC 9110, section 5.6.7), or `None` for a year that has no four digits.
#[must_use]
pub fn http_date(time: &Timestamp) -> Option<String> {
    rfc2822::DateTimePrinter::new().timestamp_to_rfc9110_string(time).ok()
}

/// True when a file written at `modified` is not newer than the date of `If-Modified-Since`, which has whole seconds.
#[must_use]
pub fn not_newer(modified: &Timestamp, since: &str) -> bool {
    let since = rfc2822::DateTimeParser::new().parse_timestamp(since);
    since.is_ok_and(|since| modified.as_second() <= since.as_second())
}
