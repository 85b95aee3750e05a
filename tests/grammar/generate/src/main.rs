//! `generate FOLDER`: writes the parser of FOLDER/grammar.js to FOLDER/src, as `tree-sitter generate --abi 14` does.

fn main() {
    let folder = std::env::args().nth(1).expect("usage: generate FOLDER");
    let folder = std::path::Path::new(&folder);
    if let Err(error) = tree_sitter_generate::generate_parser_in_directory(folder, None, 14, None, None) {
        eprintln!("{error:#}");
        std::process::exit(1);
    }
}
