package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Note;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/** The texts of a plan as blocks, by the id of their vertex or edge; those without words are missing. */
final class NetTexts {
    private static final double WIDEST_AT_VERTEX = 150;
    private static final double WIDEST_NOTE = 220;
    private static final double ROUND_SIGN = 18;

    private final Map<String, TextBlock> blocks = new LinkedHashMap<>();

    private final TextMeasure measure;

    NetTexts(Plan plan, Vocabulary vocabulary, TextMeasure measure) {
        this(plan, vocabulary, measure, NetDetail.READER);
    }

    NetTexts(Plan plan, Vocabulary vocabulary, TextMeasure measure, NetDetail detail) {
        this(plan, vocabulary, measure, detail, EdgeWords.of(plan));
    }

    /** @param edgeWords the lines at each edge, by its id */
    NetTexts(
            Plan plan,
            Vocabulary vocabulary,
            TextMeasure measure,
            NetDetail detail,
            Map<String, List<String>> edgeWords) {
        this.measure = measure;
        for (Place place : plan.places()) {
            add(place.id(), VertexWords.of(place, vocabulary, detail));
        }
        for (Transition transition : plan.transitions()) {
            add(transition.id(), VertexWords.of(transition, vocabulary, detail));
        }
        edgeWords.forEach((id, lines) -> {
            if (detail.requirements()) {
                add(id, TextBlock.of(lines, TextStyle.EDGE, measure));
            }
        });
        if (detail.missing()) {
            plan.inEdges().stream()
                    .filter(edge -> edge.requirements().isEmpty())
                    .forEach(edge -> add(edge.id(), missing()));
            plan.outEdges().stream()
                    .filter(edge -> edge.requirements().isEmpty())
                    .forEach(edge -> add(edge.id(), missing()));
        }
    }

    private TextBlock missing() {
        TextBlock sign = TextBlock.of(List.of("!"), TextStyle.MISSING, measure);
        return new TextBlock(sign.lines(), ROUND_SIGN);
    }

    private void add(String id, VertexWords words) {
        add(id, TextBlock.of(words.name(), TextStyle.NAME, words.events(), TextStyle.EVENT, WIDEST_AT_VERTEX, measure));
    }

    private void add(String id, TextBlock block) {
        if (!block.isEmpty()) {
            blocks.put(id, block);
        }
    }

    /** What is written at a vertex or an edge; an empty block where nothing is. */
    TextBlock of(String id) {
        return blocks.getOrDefault(id, new TextBlock(List.of(), 0));
    }

    /** The title of a frame, in as many lines as it needs in the frame's width. */
    TextBlock of(NetFrame frame, double width) {
        return TextBlock.of(
                frame.title(), TextStyle.NAME, List.of(), TextStyle.NAME, Math.max(40, width - ROUND_SIGN), measure);
    }

    /** What is written on a note, a paragraph for each line of its text. */
    TextBlock of(Note note) {
        List<String> paragraphs = new ArrayList<>(note.text().lines().toList());
        return TextBlock.of("", TextStyle.NOTE, paragraphs, TextStyle.NOTE, WIDEST_NOTE, measure);
    }
}
