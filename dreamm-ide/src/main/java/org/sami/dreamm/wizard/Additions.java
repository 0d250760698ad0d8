package org.sami.dreamm.wizard;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.picture.net.NetMode;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditResult;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.spn.wiring.FieldProposal;
import org.sami.spn.wiring.Wires;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;
import org.sami.spn.wizard.PlanChange;

/**
 * Adds events and vertices to the open plan, and remembers the last event that was added, so that another of its sequences can take the place
 * of the one that came with it. On the event thread; knows no Swing.
 */
public final class Additions {
    private static final double OFFSET_BELOW = 140;
    private static final LayoutPoint FIRST = new LayoutPoint(60, 200);

    private final ProjectDocument document;
    private final EditorState editor;
    private final AuthoringLibrary library;
    private final Function<Edit, EditResult> apply;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private final List<Consumer<Set<String>>> addedListeners = new CopyOnWriteArrayList<>();
    private final Wires wires;
    private final boolean alone;
    private Optional<AddEvent> last = Optional.empty();
    private Project beforeLast;
    private Project beforeNoted;
    private Optional<AddEvent> noted = Optional.empty();
    private Project after;
    private Optional<String> chainFrom = Optional.empty();
    private Optional<String> chainEnd = Optional.empty();

    /**
     * Additions to the plan that is open in an editor.
     *
     * @param wires from where the fields of added events are read where the author says nothing
     * @param alone whether events are added without the transitions and places that their domain draws with them
     * @param apply makes an edit and reports the result to the author
     */
    public Additions(
            ProjectDocument document,
            EditorState editor,
            AuthoringLibrary library,
            Wires wires,
            boolean alone,
            Function<Edit, EditResult> apply) {
        this.document = Objects.requireNonNull(document, "document");
        this.editor = Objects.requireNonNull(editor, "editor");
        this.library = Objects.requireNonNull(library, "library");
        this.wires = Objects.requireNonNull(wires, "wires");
        this.alone = alone;
        this.apply = Objects.requireNonNull(apply, "apply");
        this.after = document.project();
        this.beforeLast = document.project();
        this.beforeNoted = document.project();
        document.addListener(change -> {
            if (noted.map(AddEvent::label).equals(document.undoLabel()) && !change.isOpened()) {
                last = noted;
                beforeLast = beforeNoted;
                after = document.project();
            }
            noted = Optional.empty();
            listeners.forEach(Runnable::run);
        });
    }

    /** Whether events are added without what their domain draws with them. */
    boolean addsAlone() {
        return alone;
    }

    /** The groups and sequences of the domain. */
    public AuthoringLibrary library() {
        return library;
    }

    /** The words of the domain. */
    Vocabulary vocabulary() {
        return document.vocabulary();
    }

    /** In which mode new parts are drawn: what is made in recovery mode is a recovery part (thesis 5.1). */
    public Mode mode() {
        return editor.mode() == NetMode.NOMINAL ? Mode.NOMINAL : Mode.RECOVERY;
    }

    /** Where something goes that is added without saying where: onto the selected vertex, else behind it, else into free space. */
    public EventTarget target(boolean ontoPlaces) {
        Optional<String> vertex = next();
        if (vertex.isEmpty()) {
            return new EventTarget.Free(freePoint());
        }
        boolean place = editor.plan().flatMap(p -> p.place(vertex.get())).isPresent();
        return place == ontoPlaces ? new EventTarget.OnVertex(vertex.get()) : new EventTarget.Behind(vertex.get());
    }

    /**
     * The vertex at which the next addition goes on: the blank place at the end of what was added last while nothing else has been selected or
     * clicked since, so that additions follow each other along a chain; else the selected one.
     */
    private Optional<String> next() {
        boolean goesOn = chainFrom.equals(selectedVertex())
                && editor.plan()
                        .flatMap(p -> chainEnd.flatMap(p::place))
                        .filter(place ->
                                place.outputs().isEmpty() && place.subMissions().isEmpty() && !place.end())
                        .isPresent();
        return goesOn ? chainEnd : selectedVertex();
    }

    /** Has the next addition go to what is selected: the author has clicked there. */
    public void leaveChain() {
        chainFrom = Optional.empty();
        chainEnd = Optional.empty();
    }

    /** The first new place that is blank and from which nothing leads on; empty where an addition ends in none. */
    private static Optional<String> end(Plan before, Plan now) {
        return now.places().stream()
                .filter(place -> before.place(place.id()).isEmpty())
                .filter(place ->
                        place.outputs().isEmpty() && place.subMissions().isEmpty())
                .map(Place::id)
                .filter(id ->
                        now.inEdges().stream().noneMatch(edge -> edge.place().equals(id)))
                .findFirst();
    }

    /** The one vertex that is selected. */
    public Optional<String> selectedVertex() {
        Set<String> selection = editor.selection();
        return editor.plan()
                .flatMap(plan -> selection.stream()
                        .filter(id -> plan.place(id).isPresent()
                                || plan.transition(id).isPresent())
                        .findFirst()
                        .filter(id -> selection.size() == 1));
    }

    /** Below what is drawn; none where the layout is automatic, else a first point would move all the others. */
    private Optional<LayoutPoint> freePoint() {
        return editor.plan().flatMap(plan -> {
            int vertices = plan.places().size() + plan.transitions().size();
            if (vertices == 0) {
                return Optional.of(FIRST);
            }
            return plan.layout().size() < vertices
                    ? Optional.empty()
                    : plan.layout().values().stream()
                            .map(LayoutPoint::y)
                            .max(Double::compare)
                            .map(y -> new LayoutPoint(FIRST.x(), y + OFFSET_BELOW));
        });
    }

    /** What people call a vertex of the open plan. */
    String vertexName(String id) {
        return editor.plan()
                .flatMap(plan -> new ElementNames(plan, document.vocabulary()).of(id))
                .orElse(id);
    }

    /** What an edit would make of the open plan, or why it would be refused. */
    public Preview preview(Edit edit) {
        EditResult result = edit.apply(document.project(), document.vocabulary());
        if (result instanceof EditResult.Refused refused) {
            return new Preview(Optional.empty(), Optional.empty(), Optional.of(refused.message()));
        }
        Optional<Plan> before = editor.plan();
        Optional<Plan> planned = before.flatMap(plan -> result.project().flatMap(p -> p.plan(plan.id())));
        return new Preview(
                before.flatMap(
                        plan -> planned.map(changed -> PlanChange.between(plan, changed, document.vocabulary()))),
                planned,
                Optional.empty());
    }

    /**
     * What an edit would make.
     *
     * @param change empty where it is refused
     * @param planned the open plan as it would be; empty where the edit is refused
     * @param refusal why; empty where it is not refused
     */
    public record Preview(Optional<PlanChange> change, Optional<Plan> planned, Optional<String> refusal) {}

    /** Makes an edit of the open plan and selects the vertex that it adds first, or that it adds something to. */
    public EditResult add(Edit edit) {
        Optional<Plan> before = editor.plan();
        Project project = document.project();
        EditResult result = apply.apply(edit);
        if (result instanceof EditResult.Done && before.isPresent()) {
            last = edit instanceof AddEvent event ? Optional.of(event) : Optional.empty();
            beforeLast = project;
            after = document.project();
            editor.plan().ifPresent(now -> {
                select(before.get(), now, edit);
                tellAdded(before.get(), now);
                chainEnd = end(before.get(), now);
                chainFrom = chainEnd.isPresent() ? selectedVertex() : Optional.empty();
            });
            listeners.forEach(Runnable::run);
        }
        return result;
    }

    private void select(Plan before, Plan now, Edit edit) {
        if (edit instanceof AddEvent event && event.target() instanceof EventTarget.OnVertex on) {
            editor.select(List.of(on.vertex()));
            return;
        }
        boolean input = edit instanceof AddEvent event
                && now.transitions().stream()
                        .filter(t -> before.transition(t.id()).isEmpty())
                        .anyMatch(
                                t -> t.inputs().stream().anyMatch(i -> i.type().equals(event.event())));
        List<String> places = now.places().stream()
                .map(p -> p.id())
                .filter(id -> before.place(id).isEmpty())
                .toList();
        List<String> transitions = now.transitions().stream()
                .map(t -> t.id())
                .filter(id -> before.transition(id).isEmpty())
                .toList();
        List<String> first = input || places.isEmpty() ? transitions : places;
        first.stream().findFirst().ifPresent(id -> editor.select(List.of(id)));
    }

    private void tellAdded(Plan before, Plan now) {
        Set<String> added = new LinkedHashSet<>(editor.selection());
        now.places().stream()
                .map(p -> p.id())
                .filter(id -> before.place(id).isEmpty())
                .forEach(added::add);
        now.transitions().stream()
                .map(t -> t.id())
                .filter(id -> before.transition(id).isEmpty())
                .forEach(added::add);
        addedListeners.forEach(listener -> listener.accept(added));
    }

    /** Notes an edit that somebody else is about to make: an event that it adds can be exchanged as well. */
    public Edit noted(Edit edit) {
        noted = edit instanceof AddEvent event ? Optional.of(event) : Optional.empty();
        beforeNoted = document.project();
        return edit;
    }

    /** The event that was added last, as long as nothing was done since. */
    @SuppressWarnings("ReferenceEquality") // any other version of the project means that something was done
    public Optional<AddEvent> last() {
        return document.project() == after ? last : Optional.empty();
    }

    /** Takes the last addition back and makes it otherwise instead: with another sequence, or fields that are read from elsewhere. */
    public void exchange(UnaryOperator<AddEvent> change) {
        last().ifPresent(event -> {
            AddEvent other = change.apply(event);
            if (!other.equals(event)) {
                document.undo();
                add(other);
            }
        });
    }

    /** The edit that adds an event to the open plan as its domain offers it first, or alone; its fields are read as they are proposed. */
    public AddEvent event(String type, EventTarget target) {
        AddEvent usual = AddEvent.usual(editor.plan().orElseThrow().id(), type, target, mode(), library)
                .withWires(wires);
        return alone ? usual.withSequence(Sequence.ALONE) : usual;
    }

    /** What the fields of the event could be read from that an edit adds, or that the last addition has added. */
    public List<FieldProposal> proposals(AddEvent edit) {
        Project base = last().filter(edit::equals).isPresent() ? beforeLast : document.project();
        return wires.proposed()
                ? edit.withWires(Wires.NONE)
                        .apply(base, document.vocabulary())
                        .project()
                        .map(added -> proposals(edit, base, added))
                        .orElse(List.of())
                : List.of();
    }

    private List<FieldProposal> proposals(AddEvent edit, Project base, Project added) {
        Set<String> old = outputs(base, edit).collect(Collectors.toSet());
        return outputs(added, edit)
                .filter(id -> !old.contains(id))
                .findFirst()
                .map(id -> FieldProposal.of(added, edit.plan(), id, document.vocabulary(), library.wired(edit.event())))
                .orElse(List.of());
    }

    /** The ids of the events of a type that an edit adds. */
    private static Stream<String> outputs(Project project, AddEvent edit) {
        return project.plan(edit.plan()).stream()
                .flatMap(p -> p.places().stream())
                .flatMap(p -> p.outputs().stream())
                .filter(o -> o.type().equals(edit.event()))
                .map(OutputEventSpec::id);
    }

    /** Adds a listener that receives the ids of the vertices that {@link #add} added, and of those that it selected. */
    public void addAddedListener(Consumer<Set<String>> listener) {
        addedListeners.add(Objects.requireNonNull(listener, "listener"));
    }

    /** Adds a listener that is notified when something was added, or the document is another. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }
}
