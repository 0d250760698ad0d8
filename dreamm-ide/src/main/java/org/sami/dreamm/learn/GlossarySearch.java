package org.sami.dreamm.learn;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.Paragraph;
import org.sami.lessons.course.Step;
import org.sami.lessons.course.Term;

/** Looks for words in the glossary and in the lessons of a course. */
public final class GlossarySearch {
    private static final int AROUND = 60;

    private final Course course;

    /** A search in a course. */
    public GlossarySearch(Course course) {
        this.course = Objects.requireNonNull(course, "course");
    }

    /**
     * Something that was found.
     *
     * @param title what it is called
     * @param text what it is, or the words around what was found
     * @param where where it is explained, or stands, in words
     * @param step where one can go for it; empty where the course does not have it yet
     */
    public record Found(String title, String text, String where, Optional<StepAddress> step) {
        public Found {
            Objects.requireNonNull(title, "title");
            Objects.requireNonNull(text, "text");
            Objects.requireNonNull(where, "where");
            Objects.requireNonNull(step, "step");
        }
    }

    /** All terms, in alphabetical order, where nothing is looked for; else the terms that are called so, those that speak of it, and the steps that do. */
    public List<Found> find(String words) {
        String wanted = words.strip().toLowerCase(Locale.ROOT);
        List<Term> sorted = course.terms().stream()
                .sorted((a, b) -> a.term().compareToIgnoreCase(b.term()))
                .toList();
        if (wanted.isEmpty()) {
            return sorted.stream().map(this::found).toList();
        }
        List<Found> found = new ArrayList<>();
        sorted.stream().filter(term -> isCalled(term, wanted)).map(this::found).forEach(found::add);
        sorted.stream()
                .filter(term -> !isCalled(term, wanted) && has(term.text(), wanted))
                .map(this::found)
                .forEach(found::add);
        course.lessons()
                .forEach(lesson -> lesson.steps()
                        .forEach(step -> inStep(lesson, step, wanted).ifPresent(found::add)));
        return found;
    }

    private static boolean isCalled(Term term, String wanted) {
        return Stream.concat(Stream.of(term.id(), term.term()), term.also().stream())
                .anyMatch(each -> has(each, wanted));
    }

    private static boolean has(String text, String wanted) {
        return text.toLowerCase(Locale.ROOT).contains(wanted);
    }

    /** What is said of a term. */
    public Found found(Term term) {
        Optional<Lesson> lesson = course.lesson(term.lesson());
        Optional<StepAddress> step = course.address(term.lesson(), term.step());
        return new Found(term.term(), term.text(), lesson.map(Lesson::heading).orElse("a later lesson"), step);
    }

    private static Optional<Found> inStep(Lesson lesson, Step step, String wanted) {
        List<String> texts = new ArrayList<>(List.of(step.title()));
        step.text().forEach(paragraph -> texts.add(Paragraph.of(paragraph).words()));
        return texts.stream()
                .filter(text -> has(text, wanted))
                .findFirst()
                .map(text -> new Found(
                        step.title(),
                        around(text, wanted),
                        lesson.heading(),
                        Optional.of(new StepAddress(lesson.id(), step.id()))));
    }

    private static String around(String text, String wanted) {
        int at = text.toLowerCase(Locale.ROOT).indexOf(wanted);
        int from = Math.max(0, at - AROUND);
        int to = Math.min(text.length(), at + wanted.length() + AROUND);
        return (from > 0 ? "…" : "") + text.substring(from, to).strip() + (to < text.length() ? "…" : "");
    }
}
