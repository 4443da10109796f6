fn main() -> std::process::ExitCode {
    lightbench::command::main()
}
