package org.sami.lessons.course;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.json.Reading;

/**
 * The terms of a course and where each is explained; finds the terms that a text speaks of.
 *
 * @param terms in the order of their files
 * @param headings of the lessons, by their ids
 */
public record Glossary(List<Term> terms, Map<String, String> headings) {
    public Glossary {
        terms = List.copyOf(terms);
        headings = Map.copyOf(headings);
    }

    /**
     * Reads the glossary of a course, without its plans and jobs: that takes a moment.
     *
     * @return what could be read, and all that is wrong with it; no glossary only where {@code course.json} cannot be read
     */
    public static Reading<Glossary> read(CourseFiles course) {
        RecordFiles files = new RecordFiles(course);
        Optional<Glossary> glossary = files.record(CourseIndex.FILE, CourseIndex.class)
                .map(contents -> {
                    List<Term> terms = new ArrayList<>();
                    contents.terms().forEach(file -> terms.addAll(files.records(file, Term.class)));
                    Map<String, String> headings = new LinkedHashMap<>();
                    contents.lessons()
                            .forEach(id -> files.record(id + "/lesson.json", Lesson.class)
                                    .ifPresent(lesson -> headings.put(lesson.id(), lesson.heading())));
                    return new Glossary(terms, headings);
                });
        return new Reading<>(glossary, files.findings());
    }

    /**
     * A term where a text has it.
     *
     * @param from the index of its first character
     * @param to the index behind its last one
     */
    public record Mention(Term term, int from, int to) {
        public Mention {
            Objects.requireNonNull(term, "term");
        }
    }

    /** The heading of the lesson that explains a term; empty where the course has no such lesson. */
    public Optional<String> explainedIn(Term term) {
        return Optional.ofNullable(headings.get(term.lesson()));
    }

    /** The terms in a text as whole words, in its order. Capitals do not matter; of two that overlap, the longer one counts. */
    public List<Mention> mentions(String text) {
        String lower = text.toLowerCase(Locale.ROOT);
        List<Mention> all = new ArrayList<>();
        for (Term term : terms) {
            Stream.concat(Stream.of(term.term()), term.also().stream())
                    .forEach(name -> collect(term, name.toLowerCase(Locale.ROOT), lower, all));
        }
        all.sort(Comparator.comparingInt((Mention each) -> each.from() - each.to())
                .thenComparingInt(Mention::from));
        List<Mention> kept = new ArrayList<>();
        for (Mention each : all) {
            if (kept.stream().noneMatch(other -> each.from() < other.to() && other.from() < each.to())) {
                kept.add(each);
            }
        }
        kept.sort(Comparator.comparingInt(Mention::from));
        return kept;
    }

    private static void collect(Term term, String name, String text, List<Mention> found) {
        if (name.isEmpty()) {
            return;
        }
        for (int at = text.indexOf(name); at >= 0; at = text.indexOf(name, at + 1)) {
            int end = at + name.length();
            if (!isWordAt(text, at - 1) && !isWordAt(text, end)) {
                found.add(new Mention(term, at, end));
            }
        }
    }

    private static boolean isWordAt(String text, int index) {
        return index >= 0 && index < text.length() && Character.isLetterOrDigit(text.charAt(index));
    }
}
