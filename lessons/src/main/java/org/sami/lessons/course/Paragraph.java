package org.sami.lessons.course;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A paragraph of a step: words, some of them bold, some of them terms of the glossary. In a file {@code **bold**}, {@code [[place]]},
 * {@code [[place|places]]}; one that begins with {@code "- "} is an item of a list.
 *
 * @param isItem whether it is an item of a list
 * @param spans its parts, in order
 */
public record Paragraph(boolean isItem, List<Span> spans) {
    private static final Pattern MARKS = Pattern.compile("\\*\\*(.+?)\\*\\*|\\[\\[([^\\]|]+)(?:\\|([^\\]]+))?]]");
    private static final String ITEM = "- ";

    public Paragraph {
        spans = List.copyOf(spans);
    }

    /** A part of a paragraph. */
    public sealed interface Span {
        /** What is read. */
        String words();

        /** Plain words. */
        record Plain(String words) implements Span {}

        /** Bold words. */
        record Bold(String words) implements Span {}

        /** A term of the glossary, by its id or by words for it. */
        record TermLink(String term, String words) implements Span {
            public TermLink {
                Objects.requireNonNull(term, "term");
                Objects.requireNonNull(words, "words");
            }
        }
    }

    /** Reads one. */
    public static Paragraph of(String text) {
        boolean isItem = text.startsWith(ITEM);
        String rest = isItem ? text.substring(ITEM.length()) : text;
        List<Span> spans = new ArrayList<>();
        Matcher marks = MARKS.matcher(rest);
        int from = 0;
        while (marks.find()) {
            plain(rest.substring(from, marks.start()), spans);
            if (marks.group(1) != null) {
                spans.add(new Span.Bold(marks.group(1)));
            } else {
                String term = marks.group(2);
                spans.add(new Span.TermLink(term, marks.group(3) == null ? term : marks.group(3)));
            }
            from = marks.end();
        }
        plain(rest.substring(from), spans);
        return new Paragraph(isItem, spans);
    }

    private static void plain(String words, List<Span> spans) {
        if (!words.isEmpty()) {
            spans.add(new Span.Plain(words));
        }
    }

    /** What is read of it, without marks. */
    public String words() {
        StringBuilder all = new StringBuilder();
        spans.forEach(span -> all.append(span.words()));
        return all.toString();
    }

    /** How many words a text has that paragraphs make. */
    public static int count(List<String> paragraphs) {
        return paragraphs.stream()
                .mapToInt(each -> (int) Pattern.compile("\\s+")
                        .splitAsStream(of(each).words().strip())
                        .filter(word -> !word.isEmpty())
                        .count())
                .sum();
    }
}
