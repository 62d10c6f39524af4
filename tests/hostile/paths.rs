//! Files that are no files: only what a person names is opened whatever it is.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use hedgerow::analysis::{Disk, Reader};

/// What a command says that must end by itself.
fn hedgerow(folder: &Path, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_hedgerow"));
    command.args(arguments).current_dir(folder).stdin(Stdio::null());
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let started = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if started.elapsed() > Duration::from_secs(60) {
            child.kill().unwrap();
            panic!("it waits: {arguments:?}");
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    let output = child.wait_with_output().unwrap();
    String::from_utf8([output.stdout, output.stderr].concat()).unwrap()
}

#[test]
fn use_and_load_open_regular_files_only() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    for pipe in ["pipe.hedge", "pipe.obj"] {
        let made = Command::new("mkfifo").arg(at(pipe)).status();
        assert!(made.is_ok_and(|made| made.success()), "there is `mkfifo` on every Unix");
    }
    fs::create_dir(at("folder.hedge")).unwrap();
    fs::write(at("secret"), "root:x:0:0:secret\n").unwrap();
    fs::write(at("secret.hedge"), "root:x:0:0:secret\n").unwrap();
    std::os::unix::fs::symlink("/dev/zero", at("zero.hedge")).unwrap();
    fs::File::create(at("large.hedge")).unwrap().set_len(65 << 20).unwrap();
    for (path, wanted) in [
        ("pipe.hedge", "it is not a regular file"),
        ("zero.hedge", "it is not a regular file"),
        ("folder.hedge", "it is a folder"),
        ("large.hedge", "it is larger than 64 MiB"),
        ("none.hedge", "there is no such file"),
        ("secret", "the name of a program ends in `.hedge`"),
        ("secret.hedge", "it is not a program"),
    ] {
        fs::write(at("root.hedge"), format!("use \"{path}\"\n")).unwrap();
        let told = hedgerow(folder.path(), &["check", "root.hedge"]);
        assert!(told.contains(wanted), "{path}: {told}");
        assert!(!told.contains("root:x"), "{path}: {told}");
    }
    for (path, wanted) in [
        ("pipe.obj", "it is not a regular file"),
        ("/dev/zero", "it is not a regular file"),
        ("none.obj", "there is no such file"),
    ] {
        let test = format!("test \"t\" {{ mesh = load(\"{path}\") assert true }}\n");
        fs::write(at("root.hedge"), test).unwrap();
        let told = hedgerow(folder.path(), &["test", "root.hedge"]);
        assert!(told.contains(wanted), "{path}: {told}");
    }
}

#[test]
fn the_server_reads_programs_only() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.hedge");
    fs::write(&path, "op").unwrap();
    fs::write(folder.path().join("b.txt"), "op").unwrap();
    let name = |path: &OsStr| path.to_str().unwrap().to_owned();
    assert_eq!(Disk.read(&name(path.as_os_str())), Ok("op".to_owned()));
    assert!(Disk.read(&name(folder.path().join("b.txt").as_os_str())).is_err());
    assert!(Disk.read(&name(folder.path().as_os_str())).is_err());
}

/// Links can give a file any number of paths, and a path can leave a folder and come back.
#[test]
fn a_file_is_read_once_by_whatever_path() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    for link in ["A", "B"] {
        std::os::unix::fs::symlink(".", at(link)).unwrap();
    }
    fs::create_dir(at("sub")).unwrap();
    fs::write(at("half.hedge"), "fn half(x: real) { x / 2 }\n").unwrap();
    let whole = folder.path().canonicalize().unwrap().display().to_string();
    let paths = ["half.hedge", "A/half.hedge", "sub/../B/A/half.hedge"].map(str::to_owned);
    let whole = [format!("{whole}/half.hedge"), format!("{whole}/sub/../half.hedge")];
    let paths = [&paths[..], &whole, &[format!("/../..{}", whole[0])]].concat();
    let uses: String = paths.iter().map(|path| format!("use \"{path}\"\n")).collect();
    let text = format!("{uses}fn quarter(x: real) {{ half(half(x)) }}\n");
    fs::write(at("root.hedge"), text).unwrap();
    let told = hedgerow(folder.path(), &["check", "root.hedge"]);
    assert!(!told.contains("error"), "{told}");
    fs::write(at("loop.hedge"), "use \"A/loop.hedge\"\nuse \"B/loop.hedge\"\n").unwrap();
    let told = hedgerow(folder.path(), &["check", "loop.hedge"]);
    assert!(told.contains("`loop.hedge` uses itself"), "{told}");
    let text = "use \"std/triangle\"\nuse \"std/triangle.hedge\"\nscript s(e: edge) { split(e) }\n";
    fs::write(at("std.hedge"), text).unwrap();
    let told = hedgerow(folder.path(), &["check", "std.hedge"]);
    assert!(!told.contains("error"), "{told}");
}
