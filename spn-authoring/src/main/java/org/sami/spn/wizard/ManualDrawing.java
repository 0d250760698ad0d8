package org.sami.spn.wizard;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.Fragment;
import org.sami.spn.edit.Paste;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.sequence.Sequence;

/** Draws a manual sequence into a plan: a copy with ids of its own, its edges locked, its anchor merged with a vertex that is there. */
final class ManualDrawing {
    private final Sequence.Manual sequence;
    private final Mode mode;
    private final EditContext context;

    ManualDrawing(Sequence.Manual sequence, Mode mode, EditContext context) {
        this.sequence = sequence;
        this.mode = mode;
        this.context = context;
    }

    /** Draws the sequence with its anchor on a vertex of the plan. */
    Plan drawn(Plan plan, String vertex) throws EditRefusedException {
        Set<String> all = new LinkedHashSet<>();
        sequence.part().places().forEach(p -> all.add(p.id()));
        sequence.part().transitions().forEach(t -> all.add(t.id()));
        Optional<LayoutPoint> to = Optional.ofNullable(plan.layout().get(vertex));
        LayoutPoint from = sequence.part().layout().getOrDefault(sequence.anchor(), new LayoutPoint(0, 0));
        Paste paste = new Paste(
                plan.id(),
                Fragment.copyOf(sequence.part(), all),
                to.map(p -> p.x() - from.x()).orElse(0.0),
                to.map(p -> p.y() - from.y()).orElse(0.0));
        Map<String, String> ids = paste.idsIn(plan);
        Set<String> pasted = new LinkedHashSet<>(ids.values());
        Plan drawn = finished(paste.change(plan, context), pasted, to.isPresent());
        return merged(drawn, Objects.requireNonNull(ids.get(sequence.anchor()), "anchor"), vertex);
    }

    private Plan finished(Plan plan, Set<String> pasted, boolean laidOut) {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(plan.layout());
        if (!laidOut) {
            layout.keySet().removeAll(pasted);
        }
        return plan.withPlaces(plan.places().stream()
                        .map(p -> pasted.contains(p.id()) ? p.withMode(in(p.mode())) : p)
                        .toList())
                .withTransitions(plan.transitions().stream()
                        .map(t -> pasted.contains(t.id()) ? t.withMode(in(t.mode())) : t)
                        .toList())
                .withInEdges(plan.inEdges().stream()
                        .map(e -> pasted.contains(e.id()) ? e.withLocked(true).withMode(in(e.mode())) : e)
                        .toList())
                .withOutEdges(plan.outEdges().stream()
                        .map(e -> pasted.contains(e.id()) ? e.withLocked(true).withMode(in(e.mode())) : e)
                        .toList())
                .withLayout(layout);
    }

    private Mode in(Mode drawn) {
        return mode == Mode.RECOVERY ? mode : drawn;
    }

    /** Gives the events and edges of the anchor to a vertex that was there before. */
    private static Plan merged(Plan plan, String anchor, String vertex) {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(plan.layout());
        layout.remove(anchor);
        Optional<Place> place = plan.place(anchor);
        Optional<Transition> transition = plan.transition(anchor);
        return plan.withPlaces(plan.places().stream()
                        .filter(p -> !p.id().equals(anchor))
                        .map(p -> p.id().equals(vertex) && place.isPresent()
                                ? p.withOutputs(both(p.outputs(), place.get().outputs()))
                                : p)
                        .toList())
                .withTransitions(plan.transitions().stream()
                        .filter(t -> !t.id().equals(anchor))
                        .map(t -> t.id().equals(vertex) && transition.isPresent()
                                ? t.withInputs(both(t.inputs(), transition.get().inputs()))
                                : t)
                        .toList())
                .withInEdges(plan.inEdges().stream()
                        .map(e -> e.withPlace(instead(e.place(), anchor, vertex))
                                .withTransition(instead(e.transition(), anchor, vertex)))
                        .toList())
                .withOutEdges(plan.outEdges().stream()
                        .map(e -> e.withPlace(instead(e.place(), anchor, vertex))
                                .withTransition(instead(e.transition(), anchor, vertex)))
                        .toList())
                .withLayout(layout);
    }

    private static String instead(String id, String of, String by) {
        return id.equals(of) ? by : id;
    }

    private static <T> List<T> both(List<T> a, List<T> b) {
        return Stream.concat(a.stream(), b.stream()).toList();
    }
}
