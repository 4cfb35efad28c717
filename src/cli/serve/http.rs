//! As much of HTTP/1.1 (RFC 9112) as a server of files needs: the head of a request, the head and body of an answer.
//!
//! Written out rather than taken from a crate: the small servers hand connections to a pool of threads, and a browser's six open
//! connections, or one that does not read, then keep the seventh waiting. Here each connection has its own thread.

use std::io::{self, BufRead, BufReader, Read, Write};

/// No browser sends a longer head, fragment and all.
const MAX_HEAD_BYTES: u64 = 16 * 1024;

/// The head of a request; there is no body that a server of files would read.
#[derive(Debug)]
pub struct Request {
    /// `GET`, `HEAD`, …
    pub method: String,
    /// The path and query as sent.
    pub target: String,
    headers: Vec<(String, String)>,
    /// True when the client takes another answer on the same connection.
    pub keep_alive: bool,
}

impl Request {
    /// Waits for the next request; `None` when the client has closed the connection.
    ///
    /// # Errors
    /// [`io::ErrorKind::InvalidData`] for what is not a request, else what the connection reports, time-outs included.
    pub fn read(reader: &mut BufReader<impl Read>) -> io::Result<Option<Self>> {
        let mut head = reader.take(MAX_HEAD_BYTES);
        let Some(first) = line(&mut head)? else { return Ok(None) };
        let mut parts = first.split(' ');
        let (Some(method), Some(target), Some(version), None) =
            (parts.next(), parts.next(), parts.next(), parts.next())
        else {
            return Err(invalid("no request line"));
        };
        if !version.starts_with("HTTP/1.") {
            return Err(invalid("another version of HTTP"));
        }
        let mut headers = Vec::new();
        loop {
            let line = line(&mut head)?.ok_or_else(|| invalid("the head is cut off, or too long"))?;
            if line.is_empty() {
                break;
            }
            let (name, value) = line.split_once(':').ok_or_else(|| invalid("a header without a colon"))?;
            headers.push((name.to_owned(), value.trim().to_owned()));
        }
        let mut request = Self { method: method.to_owned(), target: target.to_owned(), headers, keep_alive: false };
        let closes = request.header("Connection").is_some_and(|value| value.eq_ignore_ascii_case("close"));
        // A body that nobody reads would be taken for the next request.
        let body = request.header("Transfer-Encoding").is_some()
            || request.header("Content-Length").is_some_and(|length| length != "0");
        request.keep_alive = version == "HTTP/1.1" && !closes && !body;
        Ok(Some(request))
    }

    /// The value of a header, whose name has no case.
    #[must_use]
    pub fn header(&self, name: &str) -> Option<&str> {
        self.headers.iter().find(|(own, _)| own.eq_ignore_ascii_case(name)).map(|(_, value)| value.as_str())
    }
}

/// A line without its end; `None` at the end of the stream or of the limit.
fn line(head: &mut impl BufRead) -> io::Result<Option<String>> {
    let mut line = String::new();
    head.read_line(&mut line)?;
    Ok(line.strip_suffix('\n').map(|line| line.strip_suffix('\r').unwrap_or(line).to_owned()))
}

fn invalid(why: &'static str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, why)
}

/// An answer, whose body is read as it is sent.
pub struct Answer {
    status: &'static str,
    headers: Vec<(&'static str, String)>,
    body: Box<dyn Read>,
    len: u64,
}

impl Answer {
    /// An answer with no body yet; `status` is the code and its phrase, `200 OK`.
    #[must_use]
    pub fn new(status: &'static str) -> Self {
        Self { status, headers: Vec::new(), body: Box::new(io::empty()), len: 0 }
    }

    /// Adds a header; its value must be free of line ends.
    #[must_use]
    pub fn header(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.headers.push((name, value.into()));
        self
    }

    /// Takes the first `len` bytes of `body`.
    #[must_use]
    pub fn body(mut self, body: impl Read + 'static, len: u64) -> Self {
        (self.body, self.len) = (Box::new(body), len);
        self
    }

    /// Takes a text for people.
    #[must_use]
    pub fn text(self, text: &'static str) -> Self {
        self.header("Content-Type", "text/plain; charset=utf-8").body(text.as_bytes(), text.len() as u64)
    }

    /// Sends it; `head_only` leaves the body out.
    ///
    /// # Errors
    /// What the connection reports, or a body that ends early: the connection is then of no further use.
    pub fn send(self, stream: &mut impl Write, head_only: bool, keep_alive: bool) -> io::Result<()> {
        let mut head = format!("HTTP/1.1 {}\r\nContent-Length: {}\r\n", self.status, self.len);
        for (name, value) in &self.headers {
            head += &format!("{name}: {value}\r\n");
        }
        head += if keep_alive { "\r\n" } else { "Connection: close\r\n\r\n" };
        stream.write_all(head.as_bytes())?;
        if !head_only && io::copy(&mut self.body.take(self.len), stream)? < self.len {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        stream.flush()
    }
}
