//! `serve`: what a page may ask of the machine.

mod contract;
mod served;

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use riffel_answers::QUESTIONS;
use riffel_answers::question::{AnyQuestion, Key, Kind, named};
use serde_json::{Value, json};

use self::served::{Served, body};
use crate::sandbox::{Sandbox, root};

/// Every path that the page asks, from the sources of its server and of its questions.
fn paths() -> Vec<String> {
    let sources = ["riffel-web/src/lib.rs", "riffel-answers/src/page/mod.rs"];
    let mut paths: Vec<String> = Vec::new();
    for source in sources {
        let text = fs::read_to_string(root().join("crates").join(source)).unwrap();
        let found = text.split('"').filter(|word| word.starts_with("/api/"));
        paths.extend(found.map(|path| path.replace("{kind}", "svg")));
    }
    paths.sort();
    paths.dedup();
    assert!(paths.len() > 25, "{paths:?}");
    paths
}

/// Keys of a case that name files, and the case that each is put into.
const FILE_KEYS: [(&str, &str); 7] = [
    ("track.measurement.file", "nominal"),
    ("wheelset.file", "nominal"),
    ("profiles.wheel", "metro-curve"),
    ("profiles.rail", "metro-curve"),
    ("profiles.rail.left", "metro-curve"),
    ("contact.from.curve", "nominal"),
    ("profiles.wheel", "nominal"),
];

/// A case with one more key, that of a file.
fn case_with(key: &str, name: &str, file: &str) -> toml::Table {
    let text = fs::read_to_string(root().join(format!("cases/{name}.toml"))).unwrap();
    let mut keys: toml::Table = text.parse().unwrap();
    let (tables, last) = key.rsplit_once('.').unwrap();
    let table = tables.split('.').fold(&mut keys, |table, name| {
        let below = table.entry(name).or_insert_with(|| toml::Table::new().into());
        if !below.is_table() {
            *below = toml::Table::new().into();
        }
        below.as_table_mut().unwrap()
    });
    table.insert(last.to_owned(), file.into());
    if key == "track.measurement.file" {
        keys["track"]["model"] = "measured".into();
    }
    keys
}

/// Questions that every path takes what it knows of, with the file in all places where a page may write.
// Long: asks every path of a page with every key that names a file, and every question with every key.
#[test]
fn no_question_of_a_page_opens_a_file_of_the_machine() {
    let sandbox = Sandbox::new();
    let words = ["secret_user", "secret_password"];
    let text = format!("{},{}\n1,2\n3,4\n", words[0], words[1]);
    fs::write(sandbox.path("secret.csv"), text).unwrap();
    let secret = sandbox.path("secret.csv").display().to_string();
    let served = Served::new(&sandbox);
    let record: String = (0..2000).map(|at| format!("{:.3},{}\n", 1e-3 * f64::from(at), at * 7919 % 41)).collect();
    let record = format!("position_m,left_um\n{record}");
    for _ in 0..2 {
        assert_eq!(served.post("/api/upload", "text/csv", &record).0, 200);
    }
    let mut through = json!({ "name": "a", "share": 1, "speed": { "mean": 25 } });
    through["curve"] = json!(secret);
    let profile = json!({ "name": secret, "orientation": null });
    let mut asked = 0;
    for (key, name) in FILE_KEYS {
        for path in paths() {
            let question = json!({
                "case": { "keys": case_with(key, name, &secret) }, "name": secret, "upload": 1,
                "traffic": { "vehicle": [through] }, "wavelength_m": 0.05, "speed_m_per_s": 25,
                "data": [{ "upload": 1, "name": secret }], "variants": [{ "keys": case_with(key, name, &secret) }],
                "wheel": profile, "rail": profile, "set": { "curve.radius": 300 }, "cost": { "grinding": secret },
                "action": [{ "title": "a", "changes": { "track": { "measurement": { "file": secret } } } }],
            });
            // A removal takes away what the next ones ask about, and chains take long.
            if path.ends_with("/remove") {
                continue;
            }
            let (status, answer) = served.ask(&path, &question);
            assert_ne!(status, 500, "{path} with {key}: {answer}");
            for word in words {
                assert!(!answer.contains(word), "{path} with {key}: {answer}");
            }
            asked += 1;
        }
    }
    assert!(asked > 150, "{asked}");
    for question in QUESTIONS.iter().map(|question| question.name()).chain(["measure", "along"]).filter_map(named) {
        for key in question.keys() {
            let (status, answer) = served.ask(
                &format!("/api/ask/{}", question.name().replace(' ', "%20")),
                &with_the_file(question, key, &secret),
            );
            let of = (question.name(), &key.name);
            // Short of a diagnosis a measured rail still has its levels.
            let is_refused = status == 422 || of.0 == "measure" && status == 200;
            assert!(is_refused || !key.is_path, "{of:?}: {answer}");
            assert_ne!(status, 500, "{of:?}: {answer}");
            for word in words {
                assert!(!answer.contains(word), "{of:?}: {answer}");
            }
        }
    }
}

/// A question with what it needs, and the file of the machine under one of its keys.
fn with_the_file(question: &dyn AnyQuestion, key: &Key, file: &str) -> Value {
    let case: toml::Table = fs::read_to_string(root().join("cases/nominal.toml")).unwrap().parse().unwrap();
    let needed = question.keys().iter().filter(|one| one.is_required && one.name != key.name);
    let needed = needed.map(|one| {
        let value = match (&*one.name, &one.kind) {
            ("case", _) => json!(case),
            (_, Kind::File) => json!({ "upload": 1, "name": file }),
            _ => json!("25 m/s"),
        };
        (one.name.clone(), value)
    });
    let own = (key.name.clone(), if key.takes_many { json!([file]) } else { json!(file) });
    Value::Object(needed.chain([own]).collect())
}

/// What a sealed run is told of files, by every way in which it may come to name one.
#[test]
fn a_run_for_a_page_reads_the_files_of_its_folder_alone() {
    let sandbox = Sandbox::new();
    let outside = tempfile::tempdir().unwrap();
    let secret = outside.path().join("secret.csv");
    fs::write(&secret, "secret_user,secret_password\n1,2\n").unwrap();
    let secret = secret.display().to_string();
    let changes = |name: &str, text: &str| fs::write(sandbox.path(name), text).unwrap();
    changes("measured.toml", &format!("[track]\nmodel = \"measured\"\nmeasurement.file = {secret:?}\n"));
    changes("wheelset.toml", &format!("[wheelset]\nmodel = \"measured\"\nfile = {secret:?}\n"));
    changes("curve-of.toml", &format!("[[vehicle]]\nname = \"a\"\nshare = 1\nspeed.mean = 20\ncurve = {secret:?}\n"));
    let own = json!({ "case": "cases/nominal.toml", "wavelength": "56 mm", "speed": 30 });
    let with = |key: &str, value: Value| {
        let mut question = json!({ "case": "cases/nominal.toml" });
        question[key] = value;
        question
    };
    let page = |name: &str, question: &Value| {
        let mut command = sandbox.command();
        let parent = std::process::id().to_string();
        command.args(["ask", "--page", &parent, name]);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let mut input = child.stdin.take().unwrap();
        input.write_all(question.to_string().as_bytes()).unwrap();
        drop(input);
        child.wait_with_output().unwrap()
    };
    assert!(page("point", &own).status.success());
    for (name, question) in [
        ("stability", json!({ "case": secret })),
        ("compare", with("with", json!(["measured.toml"]))),
        ("compare", with("with", json!(["wheelset.toml"]))),
        (
            "compare",
            json!({ "case": "cases/nominal.toml", "with": ["cases/soft-pads.toml"], "traffic": "curve-of.toml" }),
        ),
        ("map", with("set", json!([format!("track.measurement.file={secret}")]))),
        ("curve", json!({ "case": "cases/metro-curve.toml", "set": [format!("profiles.wheel={secret}")] })),
        ("roughness", json!({ "file": secret })),
        ("roughness", json!({ "file": "../secret.csv" })),
    ] {
        let output = page(name, &question);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name} {question}: {said}");
        assert!(!said.contains("secret_user"), "{said}");
        let refused = ["only files that the page has sent", "may not name any"];
        assert!(refused.iter().any(|words| said.contains(words)), "{name} {question}: {said}");
    }
}

/// A run of minutes, whose parent is killed.
// Long: waits a second to see that the run lives, and then until it has looked for its server.
#[cfg(unix)]
#[test]
fn a_run_for_a_page_ends_with_its_server() {
    let sandbox = Sandbox::new();
    let question = json!({
        "case": "cases/nominal.toml", "set": ["map.wavelength.points=9000", "map.speed.points=9000"],
    });
    fs::write(sandbox.path("question"), question.to_string()).unwrap();
    let program = env!("CARGO_BIN_EXE_riffel");
    let script = format!("'{program}' ask --page $$ map < question & echo $!; exec sleep 600");
    let mut command = Command::new("sh");
    command.args(["-c", &script]);
    command.current_dir(sandbox.path("")).stdout(Stdio::piped());
    let mut parent = command.spawn().unwrap();
    let mut line = String::new();
    let printed = BufReader::new(parent.stdout.as_mut().unwrap()).read_line(&mut line);
    printed.unwrap();
    let runs = || {
        let asked = Command::new("kill").args(["-0", line.trim()]).output();
        asked.unwrap().status.success()
    };
    std::thread::sleep(Duration::from_millis(1000));
    assert!(runs(), "it works as long as its server is there");
    parent.kill().unwrap();
    parent.wait().unwrap();
    // It looks five times a second; the rest is a machine with much to do.
    let begun = Instant::now();
    while runs() {
        assert!(begun.elapsed() < Duration::from_secs(20), "it outlives its server");
        std::thread::sleep(Duration::from_millis(50));
    }
}

#[cfg(unix)]
#[test]
fn other_machines_are_let_in_with_a_warning_only() {
    let sandbox = Sandbox::new();
    let served = Served::with(&sandbox, &["--address", "0.0.0.0"]);
    assert!(served.host.starts_with("127.0.0.1:"), "{}", served.host);
    let (_, said) = served.end("-TERM");
    assert!(said.contains("warning: other machines can reach this page"), "{said}");
}

#[test]
fn a_port_that_is_taken_is_told() {
    let sandbox = Sandbox::new();
    let served = Served::new(&sandbox);
    let (_, port) = served.host.rsplit_once(':').unwrap();
    let outcome = sandbox.riffel(&format!("serve --port {port}"));
    assert_eq!(outcome.status, Some(2));
    let told = outcome.sentence();
    assert!(told.contains(&format!("cannot listen on 127.0.0.1:{port}")) && told.contains("--port 0"), "{told}");
}

/// Pages of other origins, and names of other hosts that lead here.
#[test]
fn nobody_else_may_ask() {
    let sandbox = Sandbox::new();
    let served = Served::new(&sandbox);
    let own = &served.host;
    for (host, origin, status) in [
        (&**own, "", 403),
        (own, "Origin: http://evil.example\r\n", 403),
        ("evil.example", "Origin: http://evil.example\r\n", 421),
    ] {
        let headers = format!("Host: {host}\r\n{origin}Content-Type: application/json\r\nContent-Length: 2\r\n");
        let (found, answer) = served.send_from("POST /api/map", &headers, "{}");
        assert_eq!(found, status, "{host} {origin}: {answer}");
    }
}

#[cfg(unix)]
#[test]
fn the_end_of_a_server_leaves_nothing_behind() {
    let sandbox = Sandbox::new();
    let before = sandbox.list("");
    for signal in ["-TERM", "-INT"] {
        let served = Served::new(&sandbox);
        let table = format!("position_m,left_um\n{}", "0.001,1\n".repeat(200));
        let (_, answer) = served.post("/api/upload", "text/csv", &table);
        let kept: Value = serde_json::from_str(body(&answer)).unwrap();
        assert!(kept["bytes"].as_u64().unwrap() > 1000, "{kept}");
        assert_eq!(sandbox.list("").len(), before.len() + 1);
        assert_eq!(served.end(signal).0, Some(0), "{signal}");
        assert_eq!(sandbox.list(""), before, "{signal}");
    }
}

#[cfg(unix)]
#[test]
fn the_next_start_of_a_server_clears_up_after_a_crash() {
    let sandbox = Sandbox::new();
    let before = sandbox.list("");
    Served::new(&sandbox).end("-KILL");
    let crashed = sandbox.list("");
    assert_eq!(crashed.len(), before.len() + 1);
    let following = Served::new(&sandbox);
    let after = sandbox.list("");
    assert!(after.len() == crashed.len() && after != crashed, "{after:?}");
    following.end("-TERM");
    assert_eq!(sandbox.list(""), before);
}
