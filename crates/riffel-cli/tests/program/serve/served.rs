//! A server of a page, as a page meets it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};

use serde_json::Value;

use crate::sandbox::Sandbox;

/// A server of a page, ended with the test.
pub(super) struct Served {
    child: Child,
    /// Address and port.
    pub(super) host: String,
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Served {
    pub(super) fn new(sandbox: &Sandbox) -> Self {
        Self::with(sandbox, &[])
    }

    /// A server with more arguments.
    pub(super) fn with(sandbox: &Sandbox, arguments: &[&str]) -> Self {
        let mut command = sandbox.command();
        command.args(["serve", "--port", "0"]).args(arguments);
        command.env("TMPDIR", sandbox.path(""));
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        let printed = BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut line);
        printed.unwrap();
        let host = line.trim().strip_prefix("http://").unwrap();
        let host = host.trim_end_matches('/').to_owned();
        Self { child, host }
    }

    /// Status and body of what is answered to a page.
    pub(super) fn post(&self, path: &str, kind: &str, body: &str) -> (u16, String) {
        let content = format!("Content-Type: {kind}\r\nContent-Length: {}\r\n", body.len());
        self.send(&format!("POST {path}"), &content, body)
    }

    pub(super) fn get(&self, path: &str) -> String {
        let (status, answer) = self.send(&format!("GET {path}"), "", "");
        assert_eq!(status, 200, "{path}: {answer}");
        answer
    }

    fn send(&self, what: &str, headers: &str, body: &str) -> (u16, String) {
        let host = &self.host;
        let page = format!("Host: {host}\r\nOrigin: http://{host}\r\nX-Riffel-Page: a\r\n{headers}");
        self.send_from(what, &page, body)
    }

    /// Status and body of what is answered to whoever these headers are of.
    pub(super) fn send_from(&self, what: &str, headers: &str, body: &str) -> (u16, String) {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        let request = format!("{what} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n{body}");
        stream.write_all(request.as_bytes()).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let answer = String::from_utf8_lossy(&answer).into_owned();
        let status = answer.split(' ').nth(1).unwrap().parse().unwrap();
        (status, answer)
    }

    pub(super) fn ask(&self, path: &str, question: &Value) -> (u16, String) {
        self.post(path, "application/json", &question.to_string())
    }

    /// The document of an answer.
    pub(super) fn answer(&self, path: &str, question: &Value) -> Value {
        let (status, answer) = self.ask(path, question);
        assert_eq!(status, 200, "{path}: {answer}");
        serde_json::from_str(body(&answer)).unwrap_or_else(|error| panic!("{path}: {error}: {answer}"))
    }

    /// End it by a signal: its exit status, and what it said on standard error.
    #[cfg(unix)]
    pub(super) fn end(mut self, signal: &str) -> (Option<i32>, String) {
        let kill = Command::new("kill").args([signal, &self.child.id().to_string()]).status();
        assert!(kill.unwrap().success());
        let mut said = String::new();
        let stderr = self.child.stderr.as_mut().unwrap();
        stderr.read_to_string(&mut said).unwrap();
        (self.child.wait().unwrap().code(), said)
    }

    /// Send a table of a page.
    pub(super) fn upload(&self, text: &str) {
        assert_eq!(self.post("/api/upload", "text/csv", text).0, 200);
    }
}

/// What comes after the headers.
pub(super) fn body(answer: &str) -> &str {
    answer.split_once("\r\n\r\n").unwrap().1
}
