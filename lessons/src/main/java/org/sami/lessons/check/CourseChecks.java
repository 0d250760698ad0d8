package org.sami.lessons.check;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Step;
import org.sami.lessons.course.Term;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.vocabulary.Vocabulary;

/** Checks the content of a course that could be read (docs/writing-a-lesson.md): texts, pictures, quizzes, what is used and when it is introduced. */
public final class CourseChecks {
    private static final Pattern ID = Pattern.compile("[a-z0-9]+(-[a-z0-9]+)*");

    private static final String TERMS = "terms.json";

    private CourseChecks() {}

    /**
     * What is wrong, each with file, line and element.
     *
     * @param files where the course was read from
     */
    public static List<Finding> check(Course course, CourseFiles files, Vocabulary vocabulary) {
        List<Finding> all = new ArrayList<>();
        for (Lesson lesson : course.lessons()) {
            LessonProblems problems = new LessonProblems();
            lesson(course, lesson, vocabulary, problems);
            all.addAll(located(files, lesson.id() + "/lesson.json", problems.findings()));
        }
        for (Term term : course.terms()) {
            if (course.address("", term.lesson() + "/" + term.step()).isEmpty()) {
                Finding finding = Finding.error(
                        "E-LESSON",
                        "",
                        "the term \"" + term.id() + "\" is explained by \"" + term.lesson() + "/" + term.step()
                                + "\", which is no step of the course",
                        term.id());
                all.add(placeOf(term, files).map(finding::at).orElse(finding));
            }
        }
        return all;
    }

    /**
     * The same, and that what steps show can be played to its end and gives its result, and that jobs use what is introduced by then.
     */
    public static List<Finding> check(Course course, CourseFiles files, DomainLibrary domain) {
        List<Finding> all = new ArrayList<>(check(course, files, domain.vocabulary()));
        for (Lesson lesson : course.lessons()) {
            List<Finding> shows = new ArrayList<>();
            for (int i = 0; i < lesson.steps().size(); i++) {
                if (lesson.steps().get(i) instanceof Step.Show show) {
                    shows.addAll(ShowCheck.check(course, lesson, show, "/steps/" + i, domain));
                } else if (lesson.steps().get(i) instanceof Step.Job job) {
                    String file = lesson.id() + "/jobs/" + job.job() + ".json";
                    all.addAll(located(files, file, JobUseCheck.check(course, lesson, job.job(), domain)));
                }
            }
            all.addAll(located(files, lesson.id() + "/lesson.json", shows));
        }
        return all;
    }

    /** Where a term stands, if it is in the file that courses usually have for terms. */
    private static Optional<SourceLocation> placeOf(Term term, CourseFiles files) {
        try {
            List<String> lines = files.text(TERMS).orElse("").lines().toList();
            return Stream.iterate(0, i -> i < lines.size(), i -> i + 1)
                    .filter(i -> lines.get(i).matches(".*\"id\"\\s*:\\s*\"" + Pattern.quote(term.id()) + "\".*"))
                    .map(i -> new SourceLocation(files.name(TERMS), i + 1, 1))
                    .findFirst();
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }

    private static List<Finding> located(CourseFiles files, String file, List<Finding> findings) {
        try {
            Optional<String> text = files.text(file);
            return text.isEmpty()
                    ? findings
                    : new Reading<>(Optional.of(file), findings)
                            .locatedIn(files.name(file), text.get())
                            .findings();
        } catch (IOException unreadable) {
            return findings;
        }
    }

    private static void lesson(Course course, Lesson lesson, Vocabulary vocabulary, LessonProblems problems) {
        UseCheck.introduced(vocabulary, lesson, problems);
        TextCheck.check(course, lesson, problems);
        QuizCheck quizzes = new QuizCheck(course, vocabulary, lesson, problems);
        Set<String> ids = new HashSet<>();
        for (int i = 0; i < lesson.steps().size(); i++) {
            Step step = lesson.steps().get(i);
            String pointer = "/steps/" + i;
            if (!ID.matcher(step.id()).matches() || !ids.add(step.id())) {
                problems.add(
                        pointer + "/id",
                        "the id \"" + step.id() + "\" is not in kebab case, or there is another of it");
            }
            step.picture().ifPresent(picture -> {
                PictureCheck.check(course, lesson, picture, pointer + "/picture", problems);
                UseCheck.used(course, lesson, picture.plan(), pointer + "/picture/plan", problems);
            });
            step(course, lesson, step, pointer, quizzes, problems);
        }
    }

    private static void step(
            Course course, Lesson lesson, Step step, String pointer, QuizCheck quizzes, LessonProblems problems) {
        if (step instanceof Step.Quiz quiz) {
            quizzes.check(quiz, pointer);
        } else if (step instanceof Step.Show show) {
            UseCheck.used(course, lesson, show.plan(), pointer + "/plan", problems);
            show.result().ifPresent(result -> UseCheck.used(course, lesson, result, pointer + "/result", problems));
        } else if (step instanceof Step.Play play) {
            UseCheck.used(course, lesson, play.plan(), pointer + "/plan", problems);
            play.testCase().ifPresent(name -> quizzes.testCase(play.plan(), name, pointer + "/case"));
        }
    }
}
