package org.sami.lessons.site;

import java.util.List;

/**
 * What the template of a lesson's page reads.
 *
 * @param before the page of the lesson before it; empty text where there is none
 * @param after the page of the lesson after it; empty text where there is none
 * @param minutes how long it takes
 */
public record LessonPage(
        String id, String heading, String summary, long minutes, List<StepPart> steps, String before, String after) {
    public LessonPage {
        steps = List.copyOf(steps);
    }

    /**
     * A step.
     *
     * @param kind as in the lesson's file
     * @param svg its picture; empty text where it has none
     * @param caption of its picture
     * @param said the sentences that go with what is shown; none where it shows nothing
     * @param question the quiz as JSON for the page's script; empty text where it is none
     * @param fields what a quiz lets one choose, mark or fill in
     * @param explained the page and step that explain a quiz; empty text where it is none
     * @param job the job; has no hints where it is none
     */
    public record StepPart(
            String id,
            String kind,
            String title,
            List<ParagraphPart> paragraphs,
            String svg,
            String caption,
            List<String> said,
            String question,
            List<FieldPart> fields,
            String explained,
            JobPart job) {
        public StepPart {
            paragraphs = List.copyOf(paragraphs);
            said = List.copyOf(said);
            fields = List.copyOf(fields);
        }
    }

    /** A paragraph. */
    public record ParagraphPart(boolean item, List<SpanPart> spans) {
        public ParagraphPart {
            spans = List.copyOf(spans);
        }
    }

    /**
     * A part of a paragraph.
     *
     * @param kind {@code plain}, {@code bold} or {@code term}
     * @param term the id of the term
     * @param help what the term is
     */
    public record SpanPart(String kind, String words, String term, String help) {}

    /**
     * Something to choose, mark or fill in.
     *
     * @param type {@code radio}, {@code checkbox} or {@code number}
     * @param value the index of a choice, the id of an element, the place of tokens
     */
    public record FieldPart(String type, String value, String label) {}

    /**
     * A job.
     *
     * @param key of the project that one begins with, among those of the course
     * @param start its file, below the pages
     * @param example words of the example on another plan; none where it has no example
     * @param exampleSvg its picture
     */
    public record JobPart(
            String key, String start, List<String> hints, List<ParagraphPart> example, String exampleSvg) {
        static final JobPart NONE = new JobPart("", "", List.of(), List.of(), "");

        public JobPart {
            hints = List.copyOf(hints);
            example = List.copyOf(example);
        }
    }
}
