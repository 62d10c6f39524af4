//! Words that cannot be names in emitted code.
//!
//! Names are the same in C++ and Rust, so words that either language reserves are avoided in both.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use super::print::support;

/// Keywords of C++ up to C++23, with the alternative tokens and the contextual keywords.
const CPP: &str = "
    alignas alignof and and_eq asm atomic_cancel atomic_commit atomic_noexcept auto bitand bitor
    bool break case catch char char16_t char32_t char8_t class co_await co_return co_yield compl
    concept const const_cast consteval constexpr constinit continue contract_assert decltype
    default delete do double dynamic_cast else enum explicit export extern false final float for
    friend goto if import inline int long module mutable namespace new noexcept not not_eq nullptr
    operator or or_eq override post pre private protected public reflexpr register
    reinterpret_cast requires return short signed sizeof static static_assert static_cast struct
    switch synchronized template this thread_local throw true try typedef typeid typename typeof
    union unsigned using virtual void volatile wchar_t while xor xor_eq";

/// Keywords of Rust up to the 2024 edition, including those that are reserved for later use.
const RUST: &str = "
    Self abstract as async await become box break const continue crate do dyn else enum extern
    false final fn for gen if impl in let loop macro macro_rules match mod move mut override priv
    pub raw ref return safe self static struct super trait true try type typeof union unsafe
    unsized use virtual where while yield";

/// Macros that are not in capitals: of the standard headers, of compilers, of systems and of
/// libraries that courses and applications use. Those in capitals are recognized as such.
const MACROS: &str = "
    assert errno stdin stdout stderr offsetof setjmp va_arg va_copy va_end va_start alloca
    complex imaginary noreturn unix linux i386 vax sun mips hppa
    min max near far small hyper interface major minor makedev cdecl pascal huge environ
    isnan isinf isfinite isnormal signbit fpclassify isgreater isless isunordered
    signals slots emit foreach forever check verify require check_if verify_if
    L_tmpnam L_ctermid P_tmpdir None Bool Status Success Always Complex Expects Ensures";

/// Types and values that emitted code uses without a namespace.
const USED: &str = "
    main std mesh hedgerow journal was abs Journal Refused
    new_vertex new_halfedge new_edge new_face erase size_t ptrdiff_t int8_t int16_t int32_t int64_t
    uint8_t uint16_t uint32_t uint64_t intptr_t uintptr_t nullptr_t max_align_t FILE
    Some None Ok Err Option Vec String Box Iterator HashMap
    Mesh Level ElementKind Attribute ColumnId VertexId HalfedgeId EdgeId FaceId
    DVec2 DVec3 DVec4 DMat3 DMat4 validate_level_near";

static RESERVED: LazyLock<BTreeSet<&str>> = LazyLock::new(|| {
    let lists = [CPP, RUST, MACROS, USED].into_iter();
    lists.flat_map(str::split_whitespace).chain(support::RUST.names()).collect()
});

/// True if a word is reserved by a language, a macro, or emitted code itself.
pub(super) fn is_reserved(word: &str) -> bool {
    RESERVED.contains(word) || is_like_a_macro(word)
}

/// True if a word is a keyword of C++.
pub(super) fn is_keyword_of_cpp(word: &str) -> bool {
    CPP.split_whitespace().any(|known| known == word)
}

/// True if a word looks like a macro: all capitals, at least two of them.
fn is_like_a_macro(word: &str) -> bool {
    let capitals = word.chars().filter(char::is_ascii_uppercase).count();
    capitals > 1 && !word.contains(|c: char| c.is_lowercase()) && !word.ends_with('_')
}

/// A word that is not reserved, as close as possible to the one that is wanted; `reserved` are the
/// words that the mesh class reserves.
pub fn unreserved(word: &str, reserved: &[String]) -> String {
    match is_reserved(word) || reserved.iter().any(|known| known == word) {
        true => format!("{word}_"),
        false => word.to_owned(),
    }
}

/// A name of the program as one word, without primes, spaces (of a result without a name), and the
/// underscores that are reserved for compilers.
pub fn plain(name: &str) -> String {
    let primes = name.chars().rev().take_while(|c| *c == '\'').count();
    let stem = name.trim_end_matches('\'').replace(['\'', ' '], "_");
    let mut word = match primes {
        0 => stem,
        1 => format!("{stem}_"),
        _ => format!("{stem}_{primes}"),
    };
    // In C++, double underscores and a leading one are reserved for the compiler.
    while word.contains("__") {
        word = word.replace("__", "_");
    }
    match word.starts_with('_') {
        true => format!("x{word}"),
        false => word,
    }
}
