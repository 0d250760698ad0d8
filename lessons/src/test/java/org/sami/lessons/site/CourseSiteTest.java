package org.sami.lessons.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.course.Step;
import org.sami.spn.json.DomainLibrary;

/** The pages of the course that ships. */
class CourseSiteTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Course COURSE =
            CourseReader.read(CourseFiles.SHIPPED, DOMAIN).orThrow();
    private static final Pattern LINK = Pattern.compile("(?:href|src)=\"([^\"#]*)(?:#([^\"]*))?\"");

    /** Answers every quiz of a page once rightly and, where one can be wrong by giving nothing, once wrongly. */
    private static final String ANSWERS = """
            <script>
            window.addEventListener("load", () => {
              const said = [];
              document.querySelectorAll("form.quiz").forEach((form) => {
                const quiz = JSON.parse(form.querySelector("script").textContent);
                const output = form.querySelector("output");
                form.requestSubmit();
                said.push(output.className);
                form.querySelectorAll("input").forEach((field) => answer(quiz, field));
                form.requestSubmit();
                said.push(output.className);
              });
              document.title = "answered: " + said.join(" ");
            });
            function answer(quiz, field) {
              const value = field.dataset.value;
              const [place, kind, name] = value.split("|");
              if (quiz.ask.type === "number") {
                field.value = quiz.ask.right;
              } else if (quiz.ask.type === "mark") {
                field.checked = quiz.ask.right.includes(value);
              } else if (quiz.ask.type === "tokens") {
                const at = quiz.right.find((each) => each.place === place) || {generic: 0, robots: [], tasks: []};
                field.value = at.generic;
                field.checked = (kind === "robot" ? at.robots : at.tasks).includes(name);
              } else {
                field.checked = quiz.ask.choices[Number(value)].right;
              }
            }
            </script>""";

    @TempDir
    static Path folder;

    @BeforeAll
    static void write() throws IOException {
        int pages = new CourseSite(COURSE, DOMAIN.vocabulary()).write(folder);
        assertThat(pages).isEqualTo(COURSE.lessons().size() + 2);
    }

    @Test
    void everyLinkLeadsToAFileAndAnElementThatAreThere() throws IOException {
        for (Path page : pages()) {
            Matcher links = LINK.matcher(Files.readString(page));
            while (links.find()) {
                Path to = links.group(1).isEmpty() ? page : folder.resolve(links.group(1));
                assertThat(to).as("in %s", page.getFileName()).isRegularFile();
                if (links.group(2) != null) {
                    assertThat(Files.readString(to))
                            .as("in %s", page.getFileName())
                            .contains("id=\"" + links.group(2) + "\"");
                }
            }
        }
    }

    @Test
    void whatIsShownInDreammIsReadWithItsSentencesAndWhereItLeads() throws IOException {
        String page = Files.readString(folder.resolve("06-robots.html"));
        String step =
                page.substring(page.indexOf("<section id=\"show-joins\""), page.indexOf("<section id=\"job-late\""));

        assertThat(step).contains("<li>A transition of its own …</li>", "<svg", "What it leads to");
    }

    @Test
    void aJobHasItsExampleBehindItsHints() throws IOException {
        String page = Files.readString(folder.resolve("06-robots.html"));
        String job = page.substring(page.indexOf("<section id=\"job-late\""));

        assertThat(job).containsSubsequence("Hint 1", "Hint 2", "An example on another plan", "<svg");
    }

    @Test
    void nothingComesFromANetwork() throws IOException {
        for (Path page : pages()) {
            assertThat(Files.readString(page).replace("http://www.w3.org/2000/svg", ""))
                    .doesNotContain("http:", "https:", "src=\"//");
        }
    }

    @Test
    void everyQuizOfThePagesIsGradedInABrowser() throws Exception {
        Optional<Path> browser = Stream.of("/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome")
                .map(Path::of)
                .filter(Files::isExecutable)
                .findFirst();
        assumeTrue(browser.isPresent(), "there is no Chromium; get one by: apt-get install chromium");
        Path all = folder.resolve("all.html");
        StringBuilder sections = new StringBuilder("<body>");
        for (Path page : pages()) {
            Matcher forms =
                    Pattern.compile("(?s)<form class=\"quiz\">.*?</form>").matcher(Files.readString(page));
            while (forms.find()) {
                sections.append(forms.group());
            }
        }
        Files.writeString(all, "<script src=\"course.js\" defer></script>" + sections + ANSWERS);

        String title = titleIn(browser.get(), all);

        long quizzes = COURSE.lessons().stream()
                .flatMap(lesson -> lesson.steps().stream())
                .filter(Step.Quiz.class::isInstance)
                .count();
        List<String> expected = new ArrayList<>();
        for (int i = 0; i < quizzes; i++) {
            expected.add("wrong");
            expected.add("right");
        }
        assertThat(title).isEqualTo("answered: " + String.join(" ", expected));
    }

    private String titleIn(Path browser, Path page) throws IOException, InterruptedException {
        Path out = folder.resolve("dom.txt");
        Process process = new ProcessBuilder(
                        browser.toString(),
                        "--headless",
                        "--no-sandbox",
                        "--disable-gpu",
                        "--disable-quic",
                        "--no-first-run",
                        "--disable-background-networking",
                        "--disable-component-update",
                        "--disable-sync",
                        "--user-data-dir=" + folder.resolve("browser"),
                        "--virtual-time-budget=5000",
                        "--dump-dom",
                        page.toUri().toString())
                .redirectOutput(out.toFile())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        try {
            assertThat(process.waitFor(120, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }
        Matcher title = Pattern.compile("<title>([^<]*)</title>").matcher(Files.readString(out));
        return title.find() ? title.group(1) : "no title";
    }

    private List<Path> pages() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(".html"))
                    .sorted()
                    .toList();
        }
    }
}
