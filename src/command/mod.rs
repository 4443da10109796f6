//! The verbs of the `lightbench` command.
pub fn probe_main() {
    use std::io::Read;
    let args: Vec<String> = std::env::args().collect();
    let mut buf = Vec::new();
    std::io::stdin().read_to_end(&mut buf).unwrap();
    print!(
        "{}",
        crate::probe::run(crate::probe::topic(&args[2]).unwrap(), args.get(4).map(|s| s.as_str()), &buf)
            .unwrap()
    );
}
