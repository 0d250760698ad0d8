package org.sami.spn.planspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.Plan;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.planspace.TokenBound.Kind;
import org.sami.spn.vocabulary.Vocabulary;

/** What bounds of places say to an author, as notes: where fewer robots can be than the team has, and where tokens gather. */
public final class BoundNotes {
    private static final String BOUND = "N-BOUND";
    private static final String GATHERS = "N-GATHERS";

    /** Why they matter, and what can be done. */
    public static final List<Advice> ADVICE = List.of(
            new Advice(
                    BOUND,
                    "It shows whether a gate or a berth holds no more robots than are meant to be there.",
                    "If the number is not the one that is meant, change the requirements of the transitions before the"
                            + " place."),
            new Advice(
                    GATHERS,
                    "Each round leaves one token more: a requirement for exactly so many is then never met.",
                    "If that is not meant, let a transition take the tokens, or let the edge take instead of add."));

    private BoundNotes() {}

    /** The notes about a plan, in the order of its places. */
    public static List<Finding> of(PlanBounds bounds, Plan plan, Vocabulary vocabulary) {
        ElementNames names = new ElementNames(plan, vocabulary);
        List<Finding> notes = new ArrayList<>();
        for (PlaceBound place : bounds.places()) {
            String where = plan.place(place.place()).map(names::inSentence).orElse(place.place());
            for (TokenBound bound : place.kinds()) {
                boolean isFew = bound.kind() == Kind.ROBOT
                        && bound.most().isPresent()
                        && bound.most().getAsInt() > 0
                        && bound.most().getAsInt() < bound.of();
                if (isFew || bound.most().isEmpty()) {
                    List<String> about = new ArrayList<>(List.of(place.place()));
                    about.addAll(bound.limitedBy());
                    String words = capital(bound.words()) + " can be in " + where + " at once: " + bound.reason();
                    notes.add(new Finding(Severity.NOTE, isFew ? BOUND : GATHERS, "", words, about).inPlan(plan.id()));
                }
            }
        }
        return List.copyOf(notes);
    }

    private static String capital(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }
}
