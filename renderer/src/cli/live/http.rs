//! As much of HTTP/1.1 as the page needs: requests without bodies, one for each connection.

use std::collections::HashMap;
use std::fmt;
use std::hash::{BuildHasher, RandomState};
use std::io::{self, Read, Write};
use std::net::{IpAddr, TcpStream};
use std::time::{Duration, Instant};

/// The longest head of a request.
const MOST_BYTES: usize = 8 << 10;
/// How long a client may take to send its request, and to take the answer.
const PATIENCE: Duration = Duration::from_secs(3);

/// What whoever may see the run has been told: 128 bits that nobody guesses.
pub(super) struct Token(String);

impl Token {
    /// A new one. The keys of `RandomState` are from the operating system, and its hash tells nothing about
    /// them (SipHash).
    pub fn new() -> Self {
        let keys = RandomState::new();
        Self(format!("{:016x}{:016x}", keys.hash_one(0), keys.hash_one(1)))
    }

    /// Whether somebody knows it, found out in a time that does not tell how much of it.
    pub fn is(&self, said: &str) -> bool {
        let differences = self.0.bytes().zip(said.bytes()).fold(0, |sum, (a, b)| sum | (a ^ b));
        differences == 0 && self.0.len() == said.len()
    }
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// What a client asks for.
#[derive(Debug)]
pub(super) struct Request {
    pub method: String,
    /// Without its leading `/`.
    pub path: String,
    query: HashMap<String, String>,
    /// Where the client believes to be.
    host: String,
}

impl Request {
    /// Reads a request.
    ///
    /// # Errors
    ///
    /// If it is none that is answered: what to say, unless the client is gone or too slow.
    pub fn read(mut connection: &TcpStream) -> Result<Self, Option<Response>> {
        let deadline = Instant::now() + PATIENCE;
        let mut head = Vec::new();
        let end = loop {
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() || connection.set_read_timeout(Some(left)).is_err() {
                return Err(None);
            }
            let mut buffer = [0; 1024];
            let count = connection.read(&mut buffer).map_err(|_| None)?;
            if count == 0 {
                return Err(None);
            }
            head.extend_from_slice(&buffer[..count]);
            if let Some(end) = head.windows(4).position(|bytes| bytes == b"\r\n\r\n") {
                break end;
            }
            if head.len() > MOST_BYTES {
                return Err(Some(Response::refusal(431, "the head of the request is too long")));
            }
        };
        let head = std::str::from_utf8(&head[..end]).ok();
        head.and_then(Self::parse)
            .ok_or_else(|| Some(Response::refusal(400, "no request of HTTP/1.1")))
    }

    fn parse(head: &str) -> Option<Self> {
        let mut lines = head.split("\r\n");
        let mut words = lines.next()?.split(' ');
        let (method, target, version) = (words.next()?, words.next()?, words.next()?);
        if words.next().is_some() || !version.starts_with("HTTP/1.") {
            return None;
        }
        let headers = lines.map(|line| line.split_once(':')).collect::<Option<Vec<_>>>()?;
        let mut hosts = headers.iter().filter(|(name, _)| name.eq_ignore_ascii_case("host"));
        let (_, host) = hosts.next()?;
        if hosts.next().is_some() {
            return None;
        }
        let (path, query) = target.strip_prefix('/')?.split_once('?').unwrap_or((&target[1..], ""));
        let pairs = query.split('&').filter_map(|pair| pair.split_once('='));
        Some(Self {
            method: method.to_owned(),
            path: path.to_owned(),
            query: pairs.map(|(name, value)| (name.to_owned(), value.to_owned())).collect(),
            host: host.trim().to_owned(),
        })
    }

    /// Whether the client means this machine by a name of its own. A page of elsewhere whose name was made to
    /// lead here (DNS rebinding) says the name.
    pub fn is_for_loopback(&self) -> bool {
        let host = match self.host.rsplit_once(':') {
            Some((host, port)) if port.parse::<u16>().is_ok() => host,
            _ => &self.host,
        };
        let address = host.trim_start_matches('[').trim_end_matches(']').parse::<IpAddr>();
        host.eq_ignore_ascii_case("localhost") || address.is_ok_and(|address| address.is_loopback())
    }

    /// A finite number of the query, which is `default` where that is not given.
    pub fn number(&self, name: &str, default: Option<f64>) -> Result<f64, Response> {
        let given = self.query.get(name).map(|text| text.parse::<f64>().ok());
        let number = given.unwrap_or(default).filter(|number| number.is_finite());
        number.ok_or_else(|| Response::refusal(400, &format!("{name} is no number")))
    }
}

/// What a client gets.
#[derive(Debug)]
pub(super) struct Response {
    status: u16,
    kind: &'static str,
    body: Vec<u8>,
    /// What is white in an image of differences.
    white: Option<f32>,
}

impl Response {
    pub fn new(kind: &'static str, body: impl Into<Vec<u8>>) -> Self {
        Self { status: 200, kind, body: body.into(), white: None }
    }

    pub fn refusal(status: u16, why: &str) -> Self {
        Self { status, ..Self::new("text/plain", format!("{why}\n")) }
    }

    /// With the difference that is white in an image.
    pub fn with_white(self, white: f32) -> Self {
        Self { white: Some(white), ..self }
    }

    /// Sends it.
    pub fn write(&self, mut connection: &TcpStream) -> io::Result<()> {
        let Self { status, kind, body, white } = self;
        let white = white.map_or(String::new(), |white| format!("X-White: {white}\r\n"));
        let reason = match status {
            200 => "OK",
            400 => "Bad Request",
            403 => "Forbidden",
            404 => "Not Found",
            405 => "Method Not Allowed",
            431 => "Request Header Fields Too Large",
            _ => "Internal Server Error",
        };
        // The page needs nothing of elsewhere, and its address, which holds the token, goes nowhere else.
        let head = format!(
            "HTTP/1.1 {status} {reason}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {}\r\n\
             {white}Connection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n\
             X-Frame-Options: DENY\r\nReferrer-Policy: no-referrer\r\nContent-Security-Policy: \
             default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; connect-src 'self'; \
             img-src 'self' blob: data:\r\n\r\n",
            body.len()
        );
        connection.set_write_timeout(Some(PATIENCE))?;
        connection.write_all(&[head.as_bytes(), body].concat())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_host(host: &str) -> Option<Request> {
        Request::parse(&format!("GET /a/b?x=1.5&y=inf&z HTTP/1.1\r\nAccept: */*\r\nHost: {host}"))
    }

    #[test]
    fn requests_are_taken_apart() {
        let request = of_host(" 127.0.0.1:80 ").unwrap();
        assert_eq!((&*request.method, &*request.path), ("GET", "a/b"));
        assert_eq!(request.number("x", None).unwrap(), 1.5);
        assert_eq!(request.number("w", Some(2.0)).unwrap(), 2.0);
        for name in ["y", "z", "w"] {
            assert_eq!(request.number(name, None).unwrap_err().status, 400, "{name}");
        }
    }

    #[test]
    fn broken_requests_are_none() {
        for head in [
            "",
            "GET / HTTP/1.1",
            "GET / HTTP/1.1\r\nHost",
            "GET  / HTTP/1.1\r\nHost: localhost",
            "GET / HTTP/2\r\nHost: localhost",
            "GET http://localhost/ HTTP/1.1\r\nHost: localhost",
            "GET / HTTP/1.1\r\nHost: localhost\r\nHost: elsewhere",
        ] {
            assert!(Request::parse(head).is_none(), "{head}");
        }
    }

    #[test]
    fn other_names_of_this_machine_are_not_its_own() {
        for host in ["localhost", "LOCALHOST:8080", "127.0.0.1:1", "127.8.0.1", "[::1]:80", "[::1]"]
        {
            assert!(of_host(host).unwrap().is_for_loopback(), "{host}");
        }
        for host in ["", "localhost.evil.com", "evil.com:80", "192.168.0.1", "127.0.0.1.evil.com"] {
            assert!(!of_host(host).unwrap().is_for_loopback(), "{host}");
        }
    }

    #[test]
    fn tokens_differ_and_know_themselves() {
        let (token, other) = (Token::new(), Token::new());
        assert_eq!(token.to_string().len(), 32);
        assert!(token.is(&token.to_string()) && !token.is(&other.to_string()));
        assert!(!token.is("") && !token.is(&token.to_string()[1..]));
    }
}
