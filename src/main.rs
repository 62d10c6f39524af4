//! The program `hedgerow`.

#[cfg(target_os = "linux")]
#[global_allocator]
static ALLOCATOR: hedgerow::huge_pages::HugePages = hedgerow::huge_pages::HugePages;

fn main() -> std::process::ExitCode {
    hedgerow::cli::main()
}
