fn main() -> std::process::ExitCode {
    lightbench_command::main()
}
