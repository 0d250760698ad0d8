package org.sami.dreamm.canvas;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.NoteBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.Fragment;
import org.sami.spn.edit.FrameEdit;
import org.sami.spn.edit.NoteEdit;
import org.sami.spn.edit.Paste;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Note;
import org.sami.spn.model.Plan;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.wizard.RemoveWithRequirements;

/** What gestures and keys on the net mean as edits. Coordinates are those of the drawing. Knows no window. */
final class NetEdits {
    private final ShownNet net;
    private final FrameEdits frames;
    private final AuthoringLibrary library;

    NetEdits(ShownNet net, AuthoringLibrary library) {
        this.net = net;
        this.frames = new FrameEdits(net);
        this.library = library;
    }

    private Plan plan() {
        return net.plan();
    }

    /**
     * The edit, after one that keeps vertices where they are shown though the plan does not say so yet: else a first point would move all the
     * others.
     */
    Edit keepingTheRest(Edit edit) {
        Map<String, LayoutPoint> missing = net.withoutPoint();
        return missing.isEmpty()
                ? edit
                : new EditSequence(edit.label(), List.of(new VertexEdit.MoveVertices(plan().id(), missing), edit));
    }

    /** What is done with frames. */
    FrameEdits frames() {
        return frames;
    }

    /** Moves vertices, notes, and frames with what lies in them. */
    Edit move(Set<String> selected, double dx, double dy) {
        Set<String> selection = frames.withContents(selected);
        Map<String, LayoutPoint> centres = new LinkedHashMap<>();
        for (Vertex vertex : net.drawing().vertices()) {
            if (selection.contains(vertex.id())) {
                centres.put(
                        vertex.id(),
                        new LayoutPoint(
                                vertex.centre().x() + dx, vertex.centre().y() + dy));
            }
        }
        Map<Integer, LayoutPoint> notes = new LinkedHashMap<>();
        for (NoteBox note : net.drawing().notes()) {
            if (selection.contains(NetScene.idOf(note.index()))) {
                notes.put(note.index(), net.toPlan(note.x() + dx, note.y() + dy));
            }
        }
        List<Edit> edits = new ArrayList<>();
        if (!centres.isEmpty()) {
            edits.add(moveTo(centres));
        }
        if (!notes.isEmpty()) {
            edits.add(new NoteEdit.MoveNotes(plan().id(), notes));
        }
        frames.move(selection, dx, dy).ifPresent(edits::add);
        int count = centres.size() + notes.size() + frames.frames(selection).size();
        return one("Move " + count + " elements", edits);
    }

    /** Moves vertices to other centres. */
    Edit moveTo(Map<String, LayoutPoint> centres) {
        Map<String, LayoutPoint> to = new LinkedHashMap<>();
        centres.forEach((id, at) -> to.put(id, net.toPlan(at.x(), at.y())));
        Map<String, LayoutPoint> all = new LinkedHashMap<>(net.withoutPoint());
        all.putAll(to);
        VertexEdit.MoveVertices edit = new VertexEdit.MoveVertices(plan().id(), all);
        return all.size() == to.size()
                ? edit
                : new EditSequence(new VertexEdit.MoveVertices(plan().id(), to).label(), List.of(edit));
    }

    private static Edit one(String label, List<Edit> edits) {
        return edits.size() == 1 ? edits.get(0) : new EditSequence(label, edits);
    }

    /** Adds a blank place or transition. */
    MakingEdit add(Kind kind, double x, double y, Mode mode) {
        String id = fresh(kind == Kind.PLACE ? "place" : "transition");
        return new MakingEdit(keepingTheRest(blank(kind, id, x, y, mode)), Set.of(id));
    }

    private Edit blank(Kind kind, String id, double x, double y, Mode mode) {
        LayoutPoint at = net.toPlan(x, y);
        return kind == Kind.PLACE
                ? VertexEdit.AddPlace.blank(plan().id(), id, mode, at)
                : VertexEdit.AddTransition.blank(plan().id(), id, mode, at);
    }

    /** Adds a blank vertex of the other kind, to which an edge leads. */
    MakingEdit append(String from, double x, double y, Mode mode) {
        Kind kind = plan().place(from).isPresent() ? Kind.TRANSITION : Kind.PLACE;
        String id = fresh(kind == Kind.PLACE ? "place" : "transition");
        Edit add = blank(kind, id, x, y, mode);
        Edit both = new EditSequence(add.label(), List.of(add, new EdgeEdit.Connect(plan().id(), from, id, mode)));
        return new MakingEdit(keepingTheRest(both), Set.of(id));
    }

    Edit connect(String from, String to, Mode mode) {
        return new EdgeEdit.Connect(plan().id(), from, to, mode);
    }

    /** Why no edge can lead from a vertex to another, in one sentence; empty where one can. */
    Optional<String> whyNotConnect(String from, String to) {
        boolean place = plan().place(from).isPresent();
        if (from.equals(to)) {
            return Optional.of("An edge leads to another vertex");
        }
        if (place == plan().place(to).isPresent()) {
            return Optional.of(
                    place
                            ? "Place to place: an edge joins a place and a transition"
                            : "Transition to transition: an edge joins a transition and a place");
        }
        boolean joined = place
                ? plan().inEdges().stream()
                        .anyMatch(e -> e.place().equals(from) && e.transition().equals(to))
                : plan().outEdges().stream()
                        .anyMatch(e -> e.transition().equals(from) && e.place().equals(to));
        return joined ? Optional.of("An edge leads there already") : Optional.empty();
    }

    /** Deletes what is selected, and the requirements that only it needed (thesis 5.1.1); empty where nothing of it is there. */
    Optional<Edit> delete(Set<String> selection) {
        Set<String> elements = new LinkedHashSet<>(selection);
        elements.retainAll(plan().elementIds());
        Set<Integer> notes = notes(selection);
        List<Edit> edits = new ArrayList<>();
        if (!elements.isEmpty()) {
            edits.add(new RemoveWithRequirements(plan().id(), elements, library));
        }
        if (!notes.isEmpty()) {
            edits.add(new NoteEdit.RemoveNotes(plan().id(), notes));
        }
        Set<Integer> around = frames.frames(selection);
        if (!around.isEmpty()) {
            edits.add(new FrameEdit.RemoveFrames(plan().id(), around));
        }
        return edits.isEmpty()
                ? Optional.empty()
                : Optional.of(one("Delete " + (elements.size() + notes.size() + around.size()) + " elements", edits));
    }

    /** The indices of the notes that are selected. */
    Set<Integer> notes(Set<String> selection) {
        Set<Integer> notes = new LinkedHashSet<>();
        for (int i = 0; i < plan().notes().size(); i++) {
            if (selection.contains(NetScene.idOf(i))) {
                notes.add(i);
            }
        }
        return notes;
    }

    /** Adds a note and returns its id. */
    MakingEdit addNote(double x, double y, String text) {
        Note note = new Note(text, Optional.of(net.toPlan(x, y)));
        return new MakingEdit(
                new NoteEdit.AddNote(plan().id(), note),
                Set.of(NetScene.idOf(plan().notes().size())));
    }

    /** What is copied of a selection, in drawing units: a plan may be drawn in another scale than the one it is pasted into. */
    Fragment copy(Set<String> selection) {
        return scaled(Fragment.copyOf(plan(), selection), net.drawing().scale());
    }

    private static Fragment scaled(Fragment fragment, double factor) {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>();
        fragment.part().layout().forEach((id, at) -> layout.put(id, new LayoutPoint(at.x() * factor, at.y() * factor)));
        return new Fragment(fragment.part().withLayout(layout));
    }

    /** Pastes what was copied, its middle at a point. */
    MakingEdit paste(Fragment copied, double x, double y) {
        LayoutPoint middle = middle(copied);
        return pasteShifted(copied, x - middle.x(), y - middle.y());
    }

    /** Pastes what was copied, so far from where it was. */
    MakingEdit pasteShifted(Fragment copied, double dx, double dy) {
        double scale = net.drawing().scale();
        LayoutPoint shift = net.toPlan(dx, dy);
        Paste paste = new Paste(plan().id(), scaled(copied, 1 / scale), shift.x(), shift.y());
        Set<String> made = new LinkedHashSet<>();
        Map<String, String> ids = paste.idsIn(plan());
        copied.part().places().forEach(p -> made.add(ids.get(p.id())));
        copied.part().transitions().forEach(t -> made.add(ids.get(t.id())));
        return new MakingEdit(keepingTheRest(paste), made);
    }

    private static LayoutPoint middle(Fragment copied) {
        double x = copied.part().layout().values().stream()
                .mapToDouble(LayoutPoint::x)
                .average()
                .orElse(0);
        double y = copied.part().layout().values().stream()
                .mapToDouble(LayoutPoint::y)
                .average()
                .orElse(0);
        return new LayoutPoint(x, y);
    }

    /** A name for an element that no other has: the word with a number. */
    String fresh(String word) {
        Set<String> taken = plan().elementIds();
        int n = 1;
        while (taken.contains(word + "-" + n)) {
            n++;
        }
        return word + "-" + n;
    }

    /** The centres of the selected vertices, by their ids. */
    Map<String, LayoutPoint> centres(Set<String> selection) {
        Map<String, LayoutPoint> centres = new HashMap<>();
        net.drawing().vertices().stream()
                .filter(vertex -> selection.contains(vertex.id()))
                .forEach(vertex -> centres.put(vertex.id(), vertex.centre()));
        return centres;
    }
}
