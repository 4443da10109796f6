fn main() {
    lightbench::command::probe_main()
}
