fn main() -> lightbench::kit::lesson::Result {
    lightbench::kit::lesson::Lesson::open(1)?.answer("")
}
