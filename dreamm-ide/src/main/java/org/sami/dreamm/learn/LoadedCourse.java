package org.sami.dreamm.learn;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.lessons.progress.Learners;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;

/**
 * The course and the progress of a learner, as they were read.
 *
 * @param notes what of them could not be read, a sentence each
 */
public record LoadedCourse(LessonModel model, List<String> notes) {
    public LoadedCourse {
        Objects.requireNonNull(model, "model");
        notes = List.copyOf(notes);
    }

    /**
     * Reads both; takes a while.
     *
     * @param domain the whole domain
     * @throws IOException if there is no course, or no such learner can be, with the reason in a sentence
     */
    public static LoadedCourse read(CourseFiles files, DomainLibrary domain, Learners learners, String learner)
            throws IOException {
        Reading<Course> reading = CourseReader.read(files, domain);
        List<String> notes = new ArrayList<>();
        reading.findings().stream()
                .filter(Finding::isError)
                .map(LoadedCourse::words)
                .forEach(notes::add);
        Course course = reading.result()
                .filter(read -> !read.steps().isEmpty())
                .orElseThrow(() -> new IOException(
                        "the course cannot be read: " + (notes.isEmpty() ? "it has no lesson" : notes.get(0))));
        Learners.Opened opened = learners.open(learner);
        opened.setAside()
                .ifPresent(aside -> notes.add("The progress of " + learner + " could not be read (" + opened.why()
                        + "); it is kept as " + aside + ", and the course begins anew"));
        LearnerRecord record = new LearnerRecord(learners, opened.progress(), () -> System.nanoTime() / 1_000_000);
        return new LoadedCourse(new LessonModel(course, domain.vocabulary(), record), notes);
    }

    private static String words(Finding finding) {
        return finding.location()
                        .map(at -> at.file() + ", line " + at.line() + ": ")
                        .orElse("")
                + finding.message();
    }
}
