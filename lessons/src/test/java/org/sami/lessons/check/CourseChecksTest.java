package org.sami.lessons.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;

class CourseChecksTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final List<String> PATHS =
            List.of("course.json", "terms.json", "01-one/lesson.json", "01-one/plans/wait.json", "02-two/lesson.json");

    @TempDir
    Path folder;

    @BeforeEach
    void copyCourse() throws IOException {
        CourseFiles files = CourseFiles.onClassPath("org/sami/lessons/course-of-tests");
        for (String path : PATHS) {
            Path to = folder.resolve(path);
            Files.createDirectories(to.getParent());
            Files.writeString(to, files.text(path).orElseThrow());
        }
        change(
                "01-one/lesson.json",
                "\"events\": [\"ProxyStationKeep\"]",
                "\"events\": [\"StartSystemTimer\", \"TimerExpired\"]");
    }

    private void change(String path, String from, String to) throws IOException {
        String text = Files.readString(folder.resolve(path));
        assertThat(text).contains(from);
        Files.writeString(folder.resolve(path), text.replace(from, to));
    }

    private List<Finding> check() {
        Reading<Course> read = CourseReader.read(CourseFiles.in(folder), DOMAIN);
        assertThat(read.findings()).isEmpty();
        return CourseChecks.check(read.orThrow(), CourseFiles.in(folder), DOMAIN.vocabulary());
    }

    @Test
    void aCourseInWhichAllIsRightHasNoFindings() {
        assertThat(check()).isEmpty();
    }

    @ParameterizedTest(name = "{2}")
    @CsvSource(delimiter = '|', quoteCharacter = '§', textBlock = """
            A [[place]] is | A [[plaice]] is | no term "plaice"
            "why": "An edge is an arrow." | "why": "" | "an edge" has no "why"
            "mark": ["start"] | "mark": ["stat"] | no element "stat"
            "right": ["start", "end"] | "right": ["start", "ende"] | no element "ende"
            "explained": "places", "solved": "Both | "explained": "plcs", "solved": "Both | no step "plcs"
            "terms": ["place"] | "terms": ["plaice"] | no term "plaice"
            "events": ["StartSystemTimer", | "events": ["StartSystemTimr", | no event "StartSystemTimr"
            "events": ["StartSystemTimer", | "events": [ | uses StartSystemTimer
            "id": "which" | "id": "places" | another of it
            """)
    void whatIsWrongIsNamedWithFileAndLine(String from, String to, String words) throws IOException {
        change("01-one/lesson.json", from.strip(), to.strip());

        List<Finding> findings = check();

        assertThat(findings).anySatisfy(finding -> {
            assertThat(finding.message()).contains(words.strip());
            assertThat(finding.location().map(SourceLocation::file))
                    .contains(folder.resolve("01-one/lesson.json").toString());
            assertThat(finding.location().map(SourceLocation::line).orElse(0)).isGreaterThan(1);
        });
    }

    @Test
    void aStepThatIsTooLongIsNamed() throws IOException {
        change("02-two/lesson.json", "Tokens stand in places.", "word ".repeat(91));

        assertThat(check()).singleElement().satisfies(finding -> {
            assertThat(finding.message()).contains("\"where\" has 91 words");
            assertThat(finding.elements()).containsExactly("where");
        });
    }

    @Test
    void aTestCaseThatIsNotThereOrGoesAnotherWayIsNamed() throws IOException {
        change("02-two/lesson.json", "\"play\": \"five seconds\"", "\"play\": \"six seconds\"");
        change("01-one/plans/wait.json", "\"by\": \"PT5S\"", "\"by\": \"PT4S\"");
        change("02-two/lesson.json", "\"steps\": 0", "\"steps\": 3");

        assertThat(check())
                .extracting(Finding::message)
                .anyMatch(message -> message.contains("no test case \"six seconds\""))
                .anyMatch(message -> message.contains("has 2 steps, not 3"));
    }

    @Test
    void aTermThatIsExplainedNowhereIsNamed() throws IOException {
        change("terms.json", "\"step\": \"places\"", "\"step\": \"plcs\"");

        assertThat(check())
                .singleElement()
                .satisfies(finding -> assertThat(finding.message()).contains("01-one/plcs"))
                .satisfies(finding ->
                        assertThat(finding.location().orElseThrow().toString()).matches(".*terms\\.json:\\d+:1"));
    }
}
