package org.sami.ui.net;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.Vocabulary;

/** A plan as large as the largest that is designed for, with a layout. */
public final class WidePlan {
    /** A vocabulary that declares nothing. */
    public static final Vocabulary NO_VOCABULARY = new Vocabulary("none", List.of(), List.of(), List.of(), List.of());

    private static final int ROWS = 20;
    private static final double APART = 200;

    private WidePlan() {}

    /** A grid of so many places and as many transitions; each edge has a requirement that is written. */
    public static Plan of(int places) {
        List<Place> all = new ArrayList<>();
        List<Transition> transitions = new ArrayList<>();
        List<InEdge> in = new ArrayList<>();
        List<OutEdge> out = new ArrayList<>();
        Map<String, LayoutPoint> layout = new LinkedHashMap<>();
        for (int i = 0; i < places; i++) {
            String place = "p" + i;
            String transition = "t" + i;
            int column = i / ROWS;
            double x = 2 * APART * column;
            double y = APART * (i % ROWS);
            all.add(new Place(
                    place,
                    "Place number " + i,
                    i == 0,
                    i == places - 1,
                    false,
                    Mode.NOMINAL,
                    List.of(),
                    List.of(),
                    List.of()));
            transitions.add(new Transition(transition, "Transition " + i, Mode.NOMINAL, WaitFor.EACH, List.of()));
            layout.put(place, new LayoutPoint(x, y));
            layout.put(transition, new LayoutPoint(x + APART, y));
            in.add(new InEdge(
                    "in" + i,
                    place,
                    transition,
                    Mode.NOMINAL,
                    List.of(InRequirement.of(TokenKind.ANY_PROXY, Match.AT_LEAST, 1))));
            out.add(new OutEdge(
                    "out" + i,
                    transition,
                    "p" + (i + ROWS < places ? i + ROWS : (i + 1) % places),
                    Mode.NOMINAL,
                    List.of(OutRequirement.of(Action.TAKE, 1, TokenKind.ANY_PROXY))));
        }
        return new Plan(
                "wide",
                "Wide",
                "",
                all,
                transitions,
                in,
                out,
                List.of(),
                List.of(),
                List.of(),
                layout,
                List.of(),
                List.of());
    }
}
