//! Writes the declarations of muslin_flat.h as Rust, and says where the libraries are.
//!
//! The header is a list of plain declarations, one a line, so that a few functions read it: neither bindgen nor libclang
//! is needed. Libraries: in MUSLIN_LIB_DIR, or where pkg-config knows them; MUSLIN_STATIC=1 links the archives.
use std::{env, fmt::Write, fs, path::PathBuf, process::Command};

const PARTS: [(&str, &[&str]); 3] =
    [("print", &["pangocairo-1.0", "pango-1.0", "gobject-2.0", "cairo"]), ("exchange", &["jansson", "yaml", "expat"]), ("catalogue", &["sqlite3"])];

fn pkg_config(variable: &str) -> Option<PathBuf> {
    let found = Command::new("pkg-config").arg(format!("--variable={variable}")).arg("muslin").output().ok()?;
    found.status.success().then(|| PathBuf::from(String::from_utf8_lossy(&found.stdout).trim()))
}

fn header() -> String {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    let mut tried = vec![here.join("muslin_flat.h"), here.join("../../abi/muslin_flat.h")];
    tried.splice(0..0, env::var_os("MUSLIN_FLAT_H").map(PathBuf::from));
    tried.extend(pkg_config("prefix").map(|prefix| prefix.join("share/muslin/muslin_flat.h")));
    let path = tried.iter().find(|path| path.exists());
    let path = path.unwrap_or_else(|| panic!("muslin_flat.h is at none of {tried:?}; set MUSLIN_FLAT_H"));
    println!("cargo:rerun-if-changed={}", path.display());
    fs::read_to_string(path).unwrap()
}

fn link() {
    if let Some(folder) = env::var_os("MUSLIN_LIB_DIR").map(PathBuf::from).or_else(|| pkg_config("libdir")) {
        println!("cargo:rustc-link-search=native={}", folder.display());
    }
    let fixed = env::var_os("MUSLIN_STATIC").is_some();
    let kind = if fixed { "static" } else { "dylib" };
    for (part, needs) in PARTS {
        if env::var_os(format!("CARGO_FEATURE_{}", part.to_uppercase())).is_some() {
            println!("cargo:rustc-link-lib={kind}=muslin-{part}");
            needs.iter().filter(|_| fixed).for_each(|name| println!("cargo:rustc-link-lib=dylib={name}"));
        }
    }
    println!("cargo:rustc-link-lib={kind}=muslin\ncargo:rustc-link-lib=dylib=m");
}

/// "const double *points" as ("points", "*const f64"); array lengths behind the name make the type an array.
fn declared(text: &str) -> (String, String) {
    let (text, lengths) = text.split_at(text.find('[').unwrap_or(text.len()));
    let at = text.rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |i| i + 1);
    let (kind, name) = text.split_at(at);
    let mut made = rust_type(kind);
    for length in lengths.split(|c| c == '[' || c == ']').filter(|length| !length.is_empty()).rev() {
        made = format!("[{made}; {length}]");
    }
    (format!("r#{name}"), made)
}

fn rust_type(text: &str) -> String {
    let mut stars = text.split('*');
    let first = stars.next().unwrap();
    let mut constant = first.contains("const");
    let mut made = match first.replace("const", "").trim() {
        "int32_t" => "i32",
        "int64_t" => "i64",
        "uint64_t" => "u64",
        "uint8_t" => "u8",
        "size_t" => "usize",
        "double" => "f64",
        "float" => "f32",
        "char" => "c_char",
        "void" => "c_void",
        other => other,
    }
    .to_string();
    for after in stars {
        made = format!("*{} {made}", if constant { "const" } else { "mut" });
        constant = after.contains("const");
    }
    made
}

/// "double x, void *user" as "r#x: f64, r#user: *mut c_void", and the result behind an arrow.
fn signature(arguments: &str, result: &str) -> String {
    let items = arguments.split(", ").filter(|one| *one != "void").map(declared);
    let list: Vec<String> = items.map(|(name, kind)| format!("{name}: {kind}")).collect();
    let result = if result.trim() == "void" { String::new() } else { format!(" -> {}", rust_type(result)) };
    format!("({}){result}", list.join(", "))
}

fn translate(header: &str) -> String {
    let mut out = String::new();
    let mut feature = String::new();
    for line in header.lines().skip_while(|line| *line != "enum {") {
        let line = line.trim_end_matches([',', ';']);
        if let Some((name, value)) = line.split_once(" = ") {
            writeln!(out, "pub const {}: i32 = {value};", name.trim())
        } else if let Some((result, rest)) = line.strip_prefix("typedef ").and_then(|line| line.split_once("(*")) {
            let (name, arguments) = rest.split_once(")(").unwrap();
            let signature = signature(arguments.trim_end_matches(')'), result);
            writeln!(out, "pub type {name} = Option<unsafe extern \"C\" fn{signature}>;")
        } else if let Some(name) = line.strip_prefix("typedef struct ").and_then(|line| line.split(' ').next()) {
            let opaque = !header.contains(&format!("struct {name} {{"));
            let text = format!("#[repr(C)]\npub struct {name} {{\n    _private: [u8; 0],\n}}");
            writeln!(out, "{}", if opaque { &text } else { "" })
        } else if line == "typedef int32_t mus_status" {
            writeln!(out, "pub type mus_status = i32;")
        } else if line.starts_with("struct ") {
            writeln!(out, "#[repr(C)]\n#[derive(Clone, Copy)]\npub {line}")
        } else if line.starts_with("    ") {
            let (name, kind) = declared(line.trim());
            writeln!(out, "    pub {name}: {kind},")
        } else if let Some(part) = line.strip_prefix("/* libmuslin") {
            let part = part.trim_end_matches(" */").trim_start_matches('-');
            feature = if part.is_empty() { String::new() } else { format!("#[cfg(feature = \"{part}\")] ") };
            Ok(())
        } else if let Some((start, arguments)) = line.strip_suffix(')').and_then(|line| line.split_once('(')) {
            let at = start.rfind(|c| c == ' ' || c == '*').unwrap() + 1;
            let signature = signature(arguments, &start[..at]);
            writeln!(out, "extern \"C\" {{ {feature}pub fn {}{signature}; }}", &start[at..])
        } else {
            writeln!(out, "{}", if line == "}" && out.trim_end().ends_with(',') { "}" } else { "" })
        }
        .unwrap();
    }
    out
}

fn main() {
    for name in ["MUSLIN_LIB_DIR", "MUSLIN_STATIC", "MUSLIN_FLAT_H"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    fs::write(PathBuf::from(env::var("OUT_DIR").unwrap()).join("ffi.rs"), translate(&header())).unwrap();
    link();
}
