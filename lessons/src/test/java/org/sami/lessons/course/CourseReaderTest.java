package org.sami.lessons.course;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.Reading;

class CourseReaderTest {
    @TempDir
    Path folder;

    @Test
    void readsLessonsTermsAndPlansThatStepsName() {
        Course course = TestCourse.read();

        assertThat(course.lessons()).extracting(Lesson::id).containsExactly("01-one", "02-two");
        assertThat(course.plans()).containsOnlyKeys("01-one/wait");
        assertThat(course.plan("02-two", "01-one/wait").orElseThrow().name()).isEqualTo("Wait");
        assertThat(course.plan("01-one", "wait#wait")).isPresent();
        assertThat(course.term("Places").orElseThrow().id()).isEqualTo("place");
        assertThat(course.eventsKnown("01-one")).containsExactly("ProxyStationKeep");
        assertThat(course.eventsKnown("02-two"))
                .containsExactly("ProxyStationKeep", "StartSystemTimer", "TimerExpired");
        assertThat(course.after("01-one").orElseThrow().id()).isEqualTo("02-two");
        assertThat(course.after("02-two")).isEmpty();
        assertThat(course.address("02-two", "01-one/places")).isPresent();
        assertThat(course.address("02-two", "places")).isEmpty();
    }

    @Test
    void aLessonWithAnErrorIsNamedWithFileLineAndElementAndTheOthersWork() throws IOException {
        copyCourse();
        Path file = folder.resolve("01-one/lesson.json");
        Files.writeString(file, Files.readString(file).replace("\"caption\"", "\"captoin\""));

        Reading<Course> read = CourseReader.read(CourseFiles.in(folder), TestCourse.DOMAIN);

        assertThat(read.orThrow().lessons()).extracting(Lesson::id).containsExactly("02-two");
        Finding finding = read.findings().get(0);
        assertThat(finding.message()).contains("\"captoin\" is no member here", "caption");
        assertThat(finding.location().map(SourceLocation::file)).contains(file.toString());
        assertThat(finding.location().map(SourceLocation::line)).contains(12);
        assertThat(finding.elements()).containsExactly("places");
    }

    @Test
    void aMissingMemberIsNamed() throws IOException {
        copyCourse();
        Path file = folder.resolve("01-one/lesson.json");
        Files.writeString(
                file, Files.readString(file).replace("\"solved\": \"Places are circles.\"", "\"review\": false"));

        Finding finding = CourseReader.read(CourseFiles.in(folder), TestCourse.DOMAIN)
                .findings()
                .get(0);

        assertThat(finding.message()).isEqualTo("\"solved\" is missing");
        assertThat(finding.pointer()).isEqualTo("/steps/1/solved");
    }

    @Test
    void aTextThatIsNoTextIsRefused() throws IOException {
        copyCourse();
        Path file = folder.resolve("01-one/lesson.json");
        Files.writeString(file, Files.readString(file).replace("\"text\": \"an edge\"", "\"text\": true"));

        Reading<Course> read = CourseReader.read(CourseFiles.in(folder), TestCourse.DOMAIN);

        assertThat(read.findings()).hasSize(1);
        assertThat(read.findings().get(0).pointer()).isEqualTo("/steps/1/ask/choices/1/text");
    }

    @Test
    void aMissingPlanIsNamed() throws IOException {
        copyCourse();
        Files.delete(folder.resolve("01-one/plans/wait.json"));

        Reading<Course> read = CourseReader.read(CourseFiles.in(folder), TestCourse.DOMAIN);

        assertThat(read.orThrow().lessons()).isEmpty();
        assertThat(read.findings().get(0).message()).contains("wait.json", "no such file");
    }

    @Test
    void aQuizWithTwoRightChoicesOfOneIsRefused() throws IOException {
        copyCourse();
        Path file = folder.resolve("01-one/lesson.json");
        Files.writeString(file, Files.readString(file).replace("\"why\": \"An edge is an arrow.\"", "\"right\": true"));

        Reading<Course> read = CourseReader.read(CourseFiles.in(folder), TestCourse.DOMAIN);

        assertThat(read.findings().get(0).message()).contains("of which 2 are right");
    }

    @Test
    void aCourseWithoutContentsIsNone() {
        Reading<Course> read = CourseReader.read(CourseFiles.in(folder), TestCourse.DOMAIN);

        assertThat(read.result()).isEmpty();
        assertThat(read.findings()).hasSize(1);
    }

    private void copyCourse() throws IOException {
        for (String path : List.of(
                "course.json", "terms.json", "01-one/lesson.json", "01-one/plans/wait.json", "02-two/lesson.json")) {
            Path to = folder.resolve(path);
            Files.createDirectories(to.getParent());
            Files.writeString(to, TestCourse.FILES.text(path).orElseThrow());
        }
    }
}
