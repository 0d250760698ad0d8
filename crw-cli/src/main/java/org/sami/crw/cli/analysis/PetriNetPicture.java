package org.sami.crw.cli.analysis;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntPredicate;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;
import org.sami.picture.NetFonts;
import org.sami.picture.net.NetPicture;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.model.Action;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The picture of a place/transition net, drawn as a plan of generic tokens in layers: an arc has its weight unless that is 1, an inhibitor arc says of how many tokens there
 * must be fewer, a reset arc is dashed, and the tokens of the initial marking stand behind the names of places.
 */
final class PetriNetPicture {
    private static final String KEY =
            "A number is the weight of an arc; < 1 asks that there are fewer tokens than 1 and takes none; dashed lines empty a place.";

    private final PetriNet net;
    private final IntPredicate isDrawn;
    private final PlanBuilder plan;

    private PetriNetPicture(PetriNet net, String title, IntPredicate isDrawn) {
        this.net = net;
        this.isDrawn = isDrawn;
        plan = new PlanBuilder("net").named(title);
    }

    /**
     * An SVG document.
     *
     * @param isDrawn whether a place is drawn
     */
    static String svg(PetriNet net, String title, IntPredicate isDrawn, Vocabulary vocabulary) {
        PetriNetPicture picture = new PetriNetPicture(net, title, isDrawn);
        picture.vertices();
        for (int t = 0; t < net.transitionCount(); t++) {
            picture.arcs(t);
        }
        Plan drawn = picture.plan.build();
        return new NetPicture(NetLayout.layered(drawn, vocabulary, NetFonts::width, words(drawn)), KEY).svg();
    }

    /** The weights at the arcs, by the ids of the edges that stand for them. */
    private static Map<String, List<String>> words(Plan drawn) {
        Map<String, List<String>> words = new HashMap<>();
        drawn.inEdges()
                .forEach(edge -> words.put(
                        edge.id(),
                        edge.requirements().stream()
                                .filter(r -> r.kind() != TokenKind.UNCONDITIONAL)
                                .map(r -> r.match() == Match.LESS_THAN ? "< " + r.n() : weight(r.n()))
                                .filter(text -> !text.isEmpty())
                                .toList()));
        drawn.outEdges()
                .forEach(edge -> words.put(
                        edge.id(),
                        edge.requirements().stream()
                                .map(r -> weight(r.n()))
                                .filter(text -> !text.isEmpty())
                                .toList()));
        return words;
    }

    private static String weight(int weight) {
        return weight == 1 ? "" : String.valueOf(weight);
    }

    private void vertices() {
        for (int place = 0; place < net.placeCount(); place++) {
            if (isDrawn.test(place)) {
                plan.places(place(place));
                int tokens = net.initial(place);
                plan.name(
                        place(place), net.placeName(place) + (tokens == 0 ? "" : tokens == 1 ? " ●" : " ●×" + tokens));
            }
        }
        for (int t = 0; t < net.transitionCount(); t++) {
            plan.transition(transition(t)).name(transition(t), net.transitionName(t));
        }
    }

    private static String place(int place) {
        return "p" + place;
    }

    private static String transition(int t) {
        return "t" + t;
    }

    private void arcs(int t) {
        for (int place = 0; place < net.placeCount(); place++) {
            List<InRequirement> needs = isDrawn.test(place) ? needs(t, place) : List.of();
            if (!needs.isEmpty()) {
                plan.in(place(place), transition(t), needs.toArray(InRequirement[]::new));
            }
        }
        ArcTable produced = net.produced();
        for (int arc = produced.from(t); arc < produced.to(t); arc++) {
            if (isDrawn.test(produced.node(arc))) {
                plan.out(
                        transition(t),
                        place(produced.node(arc)),
                        new OutRequirement(TokenKind.GENERIC, produced.weight(arc), Action.TAKE, ""));
            }
        }
    }

    private List<InRequirement> needs(int t, int place) {
        List<InRequirement> needs = new ArrayList<>();
        int consumed = net.consumed().weight(t, place);
        int below = net.inhibitors().weight(t, place);
        if (consumed > 0) {
            needs.add(new InRequirement(TokenKind.GENERIC, Match.AT_LEAST, consumed, ""));
        }
        if (below > 0) {
            needs.add(new InRequirement(TokenKind.GENERIC, Match.LESS_THAN, below, ""));
        }
        if (needs.isEmpty() && net.resets().weight(t, place) > 0) {
            needs.add(InRequirement.unconditional());
        }
        return needs;
    }
}
