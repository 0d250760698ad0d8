package org.sami.lessons.check;

import java.util.List;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Paragraph;
import org.sami.lessons.course.Step;

/** Finds steps that are too long and terms that the glossary lacks. */
final class TextCheck {
    /** The most words that a step may have: what is read at a glance beside a net. */
    static final int MOST_WORDS = 90;

    private TextCheck() {}

    static void check(Course course, Lesson lesson, LessonProblems problems) {
        for (int i = 0; i < lesson.steps().size(); i++) {
            step(course, lesson.steps().get(i), "/steps/" + i, problems);
        }
        for (int i = 0; i < lesson.terms().size(); i++) {
            String id = lesson.terms().get(i);
            if (course.terms().stream().noneMatch(term -> term.id().equals(id))) {
                problems.add("/terms/" + i, "the glossary has no term \"" + id + "\"");
            }
        }
    }

    private static void step(Course course, Step step, String pointer, LessonProblems problems) {
        if (step.title().isBlank() || step.text().isEmpty()) {
            problems.add(pointer, "the step \"" + step.id() + "\" has no title or no text");
        }
        int words = Paragraph.count(step.text());
        if (words > MOST_WORDS) {
            problems.add(
                    pointer + "/text",
                    "the step \"" + step.id() + "\" has " + words + " words; at most " + MOST_WORDS
                            + " are read beside a net: divide it");
        }
        List<String> text = step.text();
        for (int i = 0; i < text.size(); i++) {
            for (Paragraph.Span span : Paragraph.of(text.get(i)).spans()) {
                if (span instanceof Paragraph.Span.TermLink link
                        && course.term(link.term()).isEmpty()) {
                    problems.add(pointer + "/text/" + i, "the glossary has no term \"" + link.term() + "\"");
                }
            }
        }
    }
}
