package org.sami.spn.drawing;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/** The texts of a plan as blocks, by the id of their vertex or edge; those without words are missing. */
final class NetTexts {
    private static final double WIDEST_AT_VERTEX = 150;

    private final Map<String, TextBlock> blocks = new LinkedHashMap<>();

    private final TextMeasure measure;

    NetTexts(Plan plan, Vocabulary vocabulary, TextMeasure measure) {
        this.measure = measure;
        for (Place place : plan.places()) {
            add(place.id(), VertexWords.of(place, vocabulary));
        }
        for (Transition transition : plan.transitions()) {
            add(transition.id(), VertexWords.of(transition, vocabulary));
        }
        EdgeWords.of(plan).forEach((id, lines) -> add(id, TextBlock.of(lines, TextStyle.EDGE, measure)));
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
}
