//! The syllabus is the only list of lessons: files, programs, figures and README agree with it, and a lesson
//! imports what has been taught.

use crate::architecture::{floors, imports};
use lightbench_kit::essay::{Essay, Glossary, Part, Values, paragraphs, plain};
use lightbench_kit::lesson::{Entry, LessonRecord, SYLLABUS};
use lightbench_kit::page;
use std::collections::BTreeSet;
use std::fs;

#[test]
fn lessons_are_numbered_in_order_and_build_on_earlier_ones() {
    assert!(SYLLABUS.is_sorted_by(|a, b| a.number < b.number));
    for entry in SYLLABUS {
        assert!(entry.question.ends_with('?'), "lesson {} asks nothing", entry.number);
        let exists = |n: u32| SYLLABUS.iter().any(|e| e.number == n);
        assert!(entry.builds_on.iter().all(|(n, _)| *n < entry.number && exists(*n)), "{}", entry.name);
    }
}

#[test]
fn the_syllabus_has_exactly_the_lessons_that_exist() {
    let expected: BTreeSet<String> = SYLLABUS.iter().map(|e| format!("{}.rs", e.stem())).collect();
    let found: BTreeSet<String> = fs::read_dir("lessons")
        .expect("lessons/")
        .flatten()
        .filter(|f| f.path().extension().is_some_and(|e| e == "rs"))
        .map(|f| f.file_name().to_string_lossy().into_owned())
        .collect();
    assert_eq!(found, expected);
}

#[test]
fn every_lesson_has_its_program() {
    let manifest = fs::read_to_string("lessons/Cargo.toml").expect("lessons/Cargo.toml");
    let lines: Vec<&str> = manifest.lines().filter(|l| l.contains("\"lesson_")).collect();
    assert_eq!(lines.len(), SYLLABUS.len());
    for entry in SYLLABUS {
        let line = format!(
            "{{ name = \"{}\", path = \"{}.rs\", test = false, doc = false }},",
            entry.program(),
            entry.stem()
        );
        assert!(lines.iter().any(|l| l.trim() == line), "lessons/Cargo.toml lacks {line}");
    }
}

#[test]
fn the_readme_names_every_lesson() {
    let readme = fs::read_to_string("README.md").expect("README.md");
    for entry in SYLLABUS {
        assert!(readme.contains(entry.question), "README.md lacks the question of lesson {}", entry.number);
    }
}

/// A lesson reads top to bottom: its header, and at most about 150 lines.
#[test]
fn lessons_are_short_and_begin_with_their_question() {
    for entry in SYLLABUS {
        let text = fs::read_to_string(format!("lessons/{}.rs", entry.stem())).expect("a lesson");
        let lines = text.lines().count();
        assert!(lines <= 160, "lesson {} has {lines} lines", entry.number);
        assert!(
            text.starts_with(&format!("//! Lesson {:02}.", entry.number)),
            "lesson {} has no header",
            entry.number
        );
        let last = if essay(entry).is_some() { "Read next:" } else { "Predict:" };
        for part in ["Builds on:", "New here:", "Notation:", "Figure:", last] {
            assert!(text.contains(part), "the header of lesson {} lacks `{part}`", entry.number);
        }
    }
}

/// Floors 0–2, `scene`, `render`, `kit` are everybody's; chapters open one by one.
#[test]
fn lessons_import_what_has_been_taught() {
    let floors = floors();
    let mut taught: BTreeSet<&str> = ["scene", "render", "figure", "lesson", "stage", "contest"].into();
    for entry in SYLLABUS {
        taught.extend(entry.introduces);
        let mut texts = vec![fs::read_to_string(format!("lessons/{}.rs", entry.stem())).expect("a lesson")];
        for file in fs::read_dir(format!("lessons/{}", entry.stem())).into_iter().flatten().flatten() {
            texts.push(fs::read_to_string(file.path()).expect("a part of a lesson"));
        }
        for (line, module) in texts
            .iter()
            .flat_map(|t| ["lightbench::", "lightbench_kit::"].iter().flat_map(|root| imports(t, root)))
        {
            let low = floors.get(&module).is_some_and(|f| *f <= 2);
            assert!(
                low || taught.contains(module.as_str()),
                "lesson {}, line {line}: `{module}` has not been taught yet",
                entry.number
            );
        }
    }
}

/// The text of a lesson's essay, if it has one.
fn essay(entry: &Entry) -> Option<String> {
    fs::read_to_string(format!("lessons/{}.md", entry.stem())).ok()
}

/// Order of sections, length, options, exercises, figures, glossary words and formulas are the reader's to check
/// (`essay::check`); the question is the syllabus's.
#[test]
fn essays_keep_their_form_and_ask_the_question_of_the_syllabus() {
    let mut essays = 0;
    for entry in SYLLABUS {
        let Some(text) = essay(entry) else { continue };
        let essay = Essay::parse(&text).unwrap_or_else(|e| panic!("lessons/{}.md: {e}", entry.stem()));
        assert_eq!(essay.question(), entry.question);
        for part in [Part::Predict, Part::Measure, Part::Breaks, Part::Use] {
            for paragraph in paragraphs(&essay, part, &Values::new()) {
                assert!(!paragraph.contains(['\\', '$', '*']), "lesson {}: {paragraph}", entry.number);
            }
        }
        essays += 1;
    }
    assert!(essays > 0, "no lesson has an essay");
}

#[test]
fn a_spoiled_essay_is_refused_with_its_reason() {
    let good = fs::read_to_string("lessons/02_sphere.md").expect("an essay");
    let spoiled = |from: &str, to: &str| {
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "nothing was spoiled: {from}");
        Essay::parse(&text).map(|_| ()).expect_err(from).to_string()
    };
    let cases = [
        ("## Predict", "## Guess", "expected one of the headings"),
        ("## See it", "## Measure it", "expected the sections"),
        ("- less than a micrometre\n", "", ""),
        ("> **Hint.**", "> **Tip.**", "**Hint.**"),
        ("1. Run", "Run", "three exercises"),
        ("![](stability)", "![](normals)", "found `normals` twice"),
        ("(#ray)", "(#rayon)", "found `#rayon`"),
        ("$r$", "$\\nosuchcommand{r}$", "cannot be read"),
        ("See it\n", &format!("See it\n{}", "word ".repeat(60)), "at most 900 words"),
    ];
    for (from, to, reason) in cases {
        if from.starts_with("- less") {
            // Two options are no choice.
            assert!(spoiled(from, to).contains("three or four options"));
            continue;
        }
        let message = spoiled(from, to);
        assert!(message.contains(reason), "{from} → {to}: {message}");
    }
}

#[test]
fn the_glossary_is_in_order_and_explains_each_word_once_in_one_sentence() {
    let text = fs::read_to_string("lessons/glossary.md").expect("the glossary");
    let lines: Vec<&str> = text.lines().filter(|l| l.starts_with("- **")).collect();
    let terms = &Glossary::book().terms;
    assert_eq!(terms.len(), lines.len(), "a line of the glossary could not be read");
    let keys: Vec<String> = terms.iter().map(|t| t.key()).collect();
    assert!(keys.windows(2).all(|k| k[0] < k[1]), "a word stands twice");
    let written: Vec<String> = Glossary::parse(&text).terms.iter().map(|t| t.word.clone()).collect();
    let in_file = lines.iter().map(|l| l.trim_start_matches("- **").split("**").next().unwrap_or_default());
    assert_eq!(written, in_file.collect::<Vec<_>>(), "the words are not in alphabetical order");
    for term in terms {
        let ends = term.meaning.matches(". ").count();
        assert!(term.meaning.ends_with('.') && ends == 0, "{}: {}", term.word, term.meaning);
    }
}

/// Formulas become one line of Unicode on the terminal.
#[test]
fn formulas_read_on_a_terminal() {
    let cases = [
        (r"\frac{a}{b + c}", "a/(b + c)"),
        (r"t_{ca} = -\mathbf{f} \cdot \mathbf{d}", "t_ca = −f · d"),
        (r"\sqrt{r^2 - d^2}", "√(r² − d²)"),
        (r"\cos\theta \le 10^{-6}", "cos θ ≤ 10⁻⁶"),
        (r"\lVert \mathbf{x} \rVert^{n}", "‖x ‖ⁿ"),
    ];
    for (latex, expected) in cases {
        assert_eq!(plain(latex), expected);
    }
}

/// What is committed in `figures/` is whole and small: every lesson's record, every file it names, the pages that
/// are made of them, and nothing else. `BLESS=1` makes the pages again from the records.
#[test]
fn the_figures_are_complete() {
    let bless = |name: &str, text: &str| {
        if std::env::var_os("BLESS").is_some() {
            fs::write(format!("figures/{name}"), text).expect("a page");
        }
    };
    let read = |name: &str| {
        fs::read_to_string(format!("figures/{name}")).unwrap_or_else(|e| panic!("figures/{name}: {e}"))
    };
    let mut records = Vec::new();
    let mut known: BTreeSet<String> = ["index.html", "glossary.html"].map(str::to_string).into();
    for entry in SYLLABUS {
        let record: LessonRecord =
            serde_json::from_str(&read(&format!("{}.json", entry.stem()))).expect("a record");
        assert_eq!(record.question, entry.question, "figures/ is older than the syllabus");
        assert!(
            !record.answer.is_empty() && record.claims.iter().all(|c| c.holds),
            "lesson {}",
            entry.number
        );
        known.extend(["json", "html"].map(|ending| format!("{}.{ending}", entry.stem())));
        for figure in &record.figures {
            assert!(figure.alt.len() > 20, "{} has no alternative text", figure.name);
            assert!(figure.caption != figure.title, "the caption of {} repeats its title", figure.name);
            assert!(!figure.command.contains("--out"), "{}", figure.command);
            for file in &figure.files {
                let size = fs::metadata(format!("figures/{file}")).map_or(0, |m| m.len());
                assert!(size > 0, "figures/{file}");
                assert!(!file.ends_with(".csv") || size <= 100_000, "figures/{file}: {size} bytes of data");
                if file.ends_with(".svg") && size > 200_000 {
                    assert!(!read(file).contains("<image "), "figures/{file} is a picture");
                }
                known.insert(file.clone());
            }
        }
        let text = essay(entry);
        let essay = text.as_deref().map(|t| Essay::parse(t).expect("an essay"));
        let made = page::lesson(entry, essay.as_ref(), &record);
        bless(&format!("{}.html", entry.stem()), &made);
        assert!(
            read(&format!("{}.html", entry.stem())) == made,
            "the page of lesson {} is not made of its record",
            entry.number
        );
        records.push(record);
    }
    bless("index.html", &page::index(&records));
    bless("glossary.html", &page::glossary());
    let index = read("index.html");
    assert!(index == page::index(&records), "figures/index.html is not made from the records beside it");
    assert!(read("glossary.html") == page::glossary());
    let files: Vec<_> = fs::read_dir("figures").expect("figures/").flatten().collect();
    for file in &files {
        let name = file.file_name().to_string_lossy().into_owned();
        assert!(known.contains(&name), "figures/{name} belongs to no lesson");
        assert!(!name.ends_with(".html") || !read(&name).contains("<script"), "pages have no scripts");
    }
    let total: u64 = files.iter().filter_map(|f| f.metadata().ok()).map(|m| m.len()).sum();
    assert!(total <= 25 << 20, "figures/ holds {total} bytes");
}
