//! `ocean-globe serve` over a real socket: ranges, types, validators, and what must never be served.

use ocean_globe::cli::serve::range::{Wanted, wanted};
use ocean_globe::cli::serve::{Serving, site::Site};
use std::collections::HashMap;
use std::fs;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};

/// A folder of its own for each test, gone at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("ocean-globe-serve-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(path.join("site/data")).unwrap();
        fs::write(path.join("secret.txt"), "outside").unwrap();
        fs::write(path.join("site/index.html"), "<!doctype html>").unwrap();
        fs::write(path.join("site/.hidden"), "hidden").unwrap();
        fs::write(path.join("site/data/a b.pmtiles"), digits()).unwrap();
        fs::write(path.join("site/empty.txt"), "").unwrap();
        fs::write(path.join("site/globe-0123456789abcdef_bg.wasm"), b"\0asm").unwrap();
        Self(path)
    }

    fn site(&self) -> PathBuf {
        self.0.join("site")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// 100,000 bytes, so large that a server may be tempted to send them in chunks; each four tell their place.
fn digits() -> Vec<u8> {
    (0..25_000_u32).flat_map(u32::to_le_bytes).collect()
}

struct Answer {
    status: u16,
    headers: HashMap<String, String>,
    body: Vec<u8>,
}

impl Answer {
    fn header(&self, name: &str) -> &str {
        self.headers.get(name).map_or("", String::as_str)
    }
}

fn ask(serving: &Serving, method: &str, target: &str, headers: &[(&str, &str)]) -> Answer {
    let mut stream = TcpStream::connect(serving.address()).unwrap();
    let lines: String = headers.iter().map(|(name, value)| format!("{name}: {value}\r\n")).collect();
    write!(stream, "{method} {target} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n{lines}\r\n").unwrap();
    let mut bytes = Vec::new();
    stream.read_to_end(&mut bytes).unwrap();
    let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").expect("a blank line after the headers");
    let head = std::str::from_utf8(&bytes[..end]).unwrap();
    let mut lines = head.split("\r\n");
    let status = lines.next().unwrap().split(' ').nth(1).unwrap().parse().unwrap();
    let pair = |line: &str| line.split_once(": ").map(|(name, value)| (name.to_ascii_lowercase(), value.to_owned()));
    Answer { status, headers: lines.filter_map(pair).collect(), body: bytes[end + 4..].to_vec() }
}

fn get(serving: &Serving, target: &str, headers: &[(&str, &str)]) -> Answer {
    ask(serving, "GET", target, headers)
}

fn serve(folder: &Folder) -> Serving {
    Serving::start(&folder.site(), "127.0.0.1", 0).unwrap()
}

const ARCHIVE: &str = "/data/a%20b.pmtiles";

#[test]
fn range_header_follows_rfc_9110() {
    let part = |from, to| Wanted::Part(from..to);
    let cases = [
        ("bytes=0-0", part(0, 1)),
        ("bytes=0-9", part(0, 10)),
        ("bytes=3-100", part(3, 10)),
        ("bytes=9-", part(9, 10)),
        ("BYTES=2-3", part(2, 4)),
        ("bytes=-1", part(9, 10)),
        ("bytes=-99", part(0, 10)),
        ("bytes=0-99999999999999999999999", part(0, 10)),
        ("bytes=10-", Wanted::Unsatisfiable),
        ("bytes=10-20", Wanted::Unsatisfiable),
        ("bytes=99999999999999999999999-", Wanted::Unsatisfiable),
        ("bytes=-0", Wanted::Unsatisfiable),
        ("bytes=5-4", Wanted::Whole),
        ("bytes=0-1,3-4", Wanted::Whole),
        ("bytes=", Wanted::Whole),
        ("bytes=-", Wanted::Whole),
        ("bytes=+1-2", Wanted::Whole),
        ("bytes=a-b", Wanted::Whole),
        ("lines=0-1", Wanted::Whole),
        ("", Wanted::Whole),
    ];
    for (header, want) in cases {
        assert_eq!(wanted(Some(header), 10), want, "{header}");
    }
    assert_eq!(wanted(None, 10), Wanted::Whole);
    assert_eq!(wanted(Some("bytes=0-"), 0), Wanted::Unsatisfiable);
    assert_eq!(wanted(Some("bytes=-1"), 0), Wanted::Unsatisfiable);
}

#[test]
fn the_page_and_its_types() {
    let folder = Folder::new("types");
    let serving = serve(&folder);
    let page = get(&serving, "/", &[]);
    assert_eq!((page.status, page.body.as_slice()), (200, b"<!doctype html>".as_slice()));
    assert_eq!(page.header("content-type"), "text/html; charset=utf-8");
    assert_eq!(page.header("cache-control"), "no-cache");
    assert_eq!(page.header("accept-ranges"), "bytes");
    assert_eq!(get(&serving, "/index.html?v=1", &[]).status, 200);

    let wasm = get(&serving, "/globe-0123456789abcdef_bg.wasm", &[]);
    assert_eq!(wasm.header("content-type"), "application/wasm");
    assert_eq!(wasm.header("cache-control"), "public, max-age=31536000, immutable");
    assert_eq!(get(&serving, ARCHIVE, &[]).header("content-type"), "application/octet-stream");
    assert_eq!(get(&serving, "/empty.txt", &[]).header("content-length"), "0");
}

#[test]
fn whole_files_and_parts() {
    let folder = Folder::new("parts");
    let (serving, bytes) = (serve(&folder), digits());
    let whole = get(&serving, ARCHIVE, &[]);
    assert_eq!((whole.status, whole.header("content-length")), (200, "100000"));
    assert!(whole.body == bytes);

    let part = get(&serving, ARCHIVE, &[("Range", "bytes=40000-80003")]);
    assert_eq!((part.status, part.header("content-length")), (206, "40004"));
    assert_eq!(part.header("content-range"), "bytes 40000-80003/100000");
    assert!(part.body == bytes[40_000..80_004]);

    let tail = get(&serving, ARCHIVE, &[("Range", "bytes=-4")]);
    assert_eq!((tail.status, tail.body.as_slice()), (206, &bytes[99_996..]));

    let past = get(&serving, ARCHIVE, &[("Range", "bytes=100000-")]);
    assert_eq!((past.status, past.header("content-range"), past.body.len()), (416, "bytes */100000", 0));

    let several = get(&serving, ARCHIVE, &[("Range", "bytes=0-1,4-5")]);
    assert_eq!((several.status, several.body.len()), (200, 100_000));
}

#[test]
fn head_sends_no_body_and_ignores_ranges() {
    let folder = Folder::new("head");
    let head = ask(&serve(&folder), "HEAD", ARCHIVE, &[("Range", "bytes=0-3")]);
    assert_eq!((head.status, head.header("content-length"), head.body.len()), (200, "100000", 0));
}

#[test]
fn validators_save_the_second_download() {
    let folder = Folder::new("validators");
    let serving = serve(&folder);
    let first = get(&serving, ARCHIVE, &[]);
    let (etag, modified) = (first.header("etag"), first.header("last-modified"));
    assert!(etag.starts_with('"') && etag.ends_with('"'), "{etag}");
    assert!(modified.ends_with(" GMT"), "{modified}");

    let weak = format!("\"other\", W/{etag}");
    for fresh in [("If-None-Match", etag), ("If-None-Match", &weak), ("If-Modified-Since", modified)] {
        let again = get(&serving, ARCHIVE, &[fresh]);
        assert_eq!((again.status, again.body.len(), again.header("etag")), (304, 0, etag), "{fresh:?}");
    }
    for stale in [("If-None-Match", "\"other\""), ("If-Modified-Since", "Thu, 01 Jan 1970 00:00:00 GMT")] {
        assert_eq!(get(&serving, ARCHIVE, &[stale]).status, 200, "{stale:?}");
    }
    let range = ("Range", "bytes=0-3");
    assert_eq!(get(&serving, ARCHIVE, &[range, ("If-Range", etag)]).status, 206);
    assert_eq!(get(&serving, ARCHIVE, &[range, ("If-Range", "\"other\"")]).status, 200);

    fs::write(folder.site().join("data/a b.pmtiles"), "new").unwrap();
    assert_eq!(get(&serving, ARCHIVE, &[("If-None-Match", etag)]).body, b"new");
}

#[test]
fn nothing_outside_the_folder_is_served() {
    let folder = Folder::new("outside");
    let serving = serve(&folder);
    for target in [
        "/../secret.txt",
        "/data/../../secret.txt",
        "/%2e%2e/secret.txt",
        "/..%2fsecret.txt",
        "/%2e%2e%5csecret.txt",
        "/..\\secret.txt",
        "//../secret.txt",
        "/data/%00",
        "/index.html%00.png",
        "/index.html%0",
        "/index.html%+1",
        "/%ff",
        "/.hidden",
        "/data",
        "/data/",
        "/missing",
        "/index.html/",
        "http://localhost/index.html",
    ] {
        let answer = get(&serving, target, &[]);
        assert_eq!(answer.status, 404, "{target}: {}", String::from_utf8_lossy(&answer.body));
    }
    let post = ask(&serving, "POST", "/index.html", &[("Content-Length", "0")]);
    assert_eq!((post.status, post.header("allow")), (405, "GET, HEAD"));
}

#[test]
fn one_connection_takes_many_requests_and_no_nonsense() {
    let folder = Folder::new("keep-alive");
    let serving = serve(&folder);
    let talk = |text: &str| {
        let mut stream = TcpStream::connect(serving.address()).unwrap();
        // An answer may come before all is written, and close the connection.
        let _ = stream.write_all(text.as_bytes());
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        String::from_utf8_lossy(&bytes).into_owned()
    };
    let two = "HEAD /empty.txt HTTP/1.1\r\n\r\nGET / HTTP/1.1\r\nConnection: close\r\n\r\n";
    let answer = talk(two);
    assert_eq!(answer.matches("HTTP/1.1 200 OK\r\n").count(), 2, "{answer}");
    assert!(answer.ends_with("\r\n\r\n<!doctype html>"), "{answer}");
    // Without the answer "close", this would wait for the time-out.
    assert!(talk("GET / HTTP/1.0\r\n\r\n").contains("Connection: close\r\n"));
    // The body must not be read as a request of its own.
    let smuggled = talk("POST / HTTP/1.1\r\nContent-Length: 40\r\n\r\nGET / HTTP/1.1\r\nConnection: close\r\n\r\n");
    assert_eq!(smuggled.matches("HTTP/1.1 ").count(), 1, "{smuggled}");
    for nonsense in ["\r\n\r\n", "GET /\r\n\r\n", "GET / HTTP/2\r\n\r\n", "GET / HTTP/1.1\r\nno colon\r\n\r\n"] {
        assert!(talk(nonsense).starts_with("HTTP/1.1 400 "), "{nonsense:?}");
    }
    let long = format!("GET / HTTP/1.1\r\nCookie: {}\r\n\r\n", "x".repeat(20_000));
    assert!(!talk(&long).contains("200 OK"));
}

#[cfg(unix)]
#[test]
fn links_lead_nowhere_outside() {
    let folder = Folder::new("links");
    let link = |target: &Path, name: &str| std::os::unix::fs::symlink(target, folder.site().join(name)).unwrap();
    link(&folder.0.join("secret.txt"), "out.txt");
    link(&folder.site().join("index.html"), "in.html");
    let serving = serve(&folder);
    assert_eq!(get(&serving, "/out.txt", &[]).status, 404);
    assert_eq!(get(&serving, "/in.html", &[]).status, 200);
}

#[test]
fn clients_that_never_read_do_not_stop_the_others() {
    let folder = Folder::new("slow");
    fs::write(folder.site().join("large.bin"), vec![7; 32 << 20]).unwrap();
    let serving = serve(&folder);
    let idle: Vec<TcpStream> = (0..64)
        .map(|_| {
            let mut stream = TcpStream::connect(serving.address()).unwrap();
            write!(stream, "GET /large.bin HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
            stream
        })
        .collect();
    assert_eq!(get(&serving, "/", &[]).status, 200);
    drop(idle);
}

#[test]
fn what_cannot_be_served_says_what_to_do() {
    let folder = Folder::new("refused");
    let missing = Serving::start(&folder.0.join("nowhere"), "127.0.0.1", 0).err().unwrap().to_string();
    assert!(missing.contains("nowhere") && missing.contains("make build"), "{missing}");
    let empty = Site::open(&folder.site().join("data")).unwrap_err().to_string();
    assert!(empty.contains("index.html") && empty.contains("make build"), "{empty}");
    let serving = serve(&folder);
    let taken = Serving::start(&folder.site(), "127.0.0.1", serving.address().port()).err().unwrap().to_string();
    assert!(taken.contains(&serving.address().to_string()) && taken.contains("--port"), "{taken}");
}

#[test]
fn dropping_it_frees_the_port() {
    let folder = Folder::new("drop");
    let serving = serve(&folder);
    let address = serving.address();
    drop(serving);
    for _ in 0..100 {
        if TcpStream::connect(address).is_err() {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    panic!("{address} still answers two seconds later");
}
