package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.NetOverlay;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.SetDisabled;
import org.sami.spn.edit.SetMode;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.wizard.ChangeWaiting;

/** Name, start, end, waiting and mode of the selected vertices; of several what they have in common. */
final class VertexSection extends Form {
    private final transient DreammContext context;
    private final String plan;
    private final transient Selected selected;

    VertexSection(DreammContext context, Plan plan, Selected selected) {
        this.context = context;
        this.plan = plan.id();
        this.selected = selected;
        setName("inspector-vertex");
        if (selected.vertices() == 1) {
            single();
        }
        if (!selected.places().isEmpty()) {
            places(selected.places());
        }
        if (!selected.transitions().isEmpty()) {
            choice(
                    "Fires",
                    "inspector-wait-for",
                    "Whether it fires for each answer, or waits until all who stand in its places have answered",
                    List.of(WaitFor.values()),
                    common(selected.transitions(), Transition::waitFor),
                    w -> w == WaitFor.EACH ? "for each answer" : "once, when all answered",
                    w -> each(
                            "Change waiting",
                            selected.transitions().stream()
                                    .map(t -> new ChangeWaiting(
                                            this.plan,
                                            t.id(),
                                            w,
                                            context.additions().library()))));
        }
        flag(
                "Disabled for trying",
                "inspector-disabled",
                "Try it leaves it out: a place sends nothing and starts no sub-mission, a transition never fires. A"
                        + " mission takes no notice",
                selected.places().stream().allMatch(Place::disabled)
                        && selected.transitions().stream().allMatch(Transition::disabled),
                off -> context.apply(new SetDisabled(this.plan, vertices(), off)));
        Stream<Mode> modes = Stream.concat(
                Stream.concat(
                        selected.places().stream().map(Place::mode),
                        selected.transitions().stream().map(Transition::mode)),
                Stream.concat(
                        selected.inEdges().stream().map(e -> e.mode()),
                        selected.outEdges().stream().map(e -> e.mode())));
        choice(
                "Drawn",
                "inspector-mode",
                "Recovery parts are hidden while the nominal plan is shown (thesis 5.1)",
                List.of(Mode.values()),
                common(modes.toList(), m -> m),
                m -> m == Mode.NOMINAL ? "in the nominal plan" : "as recovery",
                m -> context.apply(new SetMode(this.plan, selected.elements(), m)));
    }

    private Set<String> vertices() {
        Set<String> ids = new LinkedHashSet<>();
        selected.places().forEach(p -> ids.add(p.id()));
        selected.transitions().forEach(t -> ids.add(t.id()));
        return ids;
    }

    private void single() {
        boolean place = !selected.places().isEmpty();
        String id = place
                ? selected.places().get(0).id()
                : selected.transitions().get(0).id();
        String name = place
                ? selected.places().get(0).name()
                : selected.transitions().get(0).name();
        text(
                "Name",
                "inspector-name",
                "What people call it; its id in the file is " + id,
                name,
                n -> context.apply(new VertexEdit.NameVertex(plan, id, n)));
        NetOverlay.Shown shown = context.overlay().shown();
        if (shown.badges().bounds().containsKey(id)) {
            shown.why()
                    .apply(id)
                    .ifPresent(words ->
                            note("Bound: " + words + ".", SemanticColor.MUTED).setName("inspector-bound"));
        }
    }

    private void places(List<Place> places) {
        if (places.size() == 1) {
            Place place = places.get(0);
            flag(
                            "Start of the plan",
                            "inspector-start",
                            place.start()
                                    ? "Make another place the start instead: a plan has one"
                                    : "Missions begin here; the start so far becomes an ordinary place",
                            place.start(),
                            s -> context.apply(new VertexEdit.SetStart(plan, place.id())))
                    .setEnabled(!place.start());
        }
        boolean allEnd = places.stream().allMatch(Place::end);
        flag(
                "End of the plan",
                "inspector-end",
                "The mission is over when this place is entered",
                allEnd,
                end -> each(
                        "Change ends",
                        places.stream().map(p -> new VertexEdit.SetEnd(plan, p.id(), end, p.endsSharedInstance()))));
        if (allEnd) {
            flag(
                    "Ends a static sub-mission",
                    "inspector-ends-shared",
                    "Where the plan runs as a static sub-mission, this end place ends the instance for all; any other"
                            + " returns only those who enter it",
                    places.stream().allMatch(Place::endsSharedInstance),
                    ends -> each(
                            "Change ends", places.stream().map(p -> new VertexEdit.SetEnd(plan, p.id(), true, ends))));
        }
    }

    private void each(String label, Stream<? extends Edit> edits) {
        List<Edit> all = new ArrayList<>(edits.toList());
        context.apply(all.size() == 1 ? all.get(0) : new EditSequence(label, all));
    }

    /** What all have in common; empty where they differ. */
    static <E, T> Optional<T> common(Collection<E> elements, Function<E, T> of) {
        Set<T> values = new LinkedHashSet<>();
        elements.forEach(e -> values.add(of.apply(e)));
        return values.size() == 1 ? Optional.of(values.iterator().next()) : Optional.empty();
    }
}
