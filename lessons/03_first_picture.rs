fn main() -> lightbench::kit::lesson::Result {
    lightbench::kit::lesson::Lesson::open(3)?.answer("")
}
