package org.sami.dreamm.canvas;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.sami.dreamm.canvas.AppendChoices.NextStep;
import org.sami.dreamm.context.DreammContext;
import org.sami.picture.net.NetMode;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.Fragment;
import org.sami.spn.edit.FrameEdit;
import org.sami.spn.edit.NoteEdit;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.ui.net.NetView;

/** What gestures, keys and menus do on the net: each is an edit of the document, and what it made is selected. On the event thread. */
final class NetActions {
    private static final double PASTE_OFFSET = 140;

    private final DreammContext context;
    private final NetView view;
    private final ShownNet net;
    private final NetEdits edits;
    private final WriteInPlace writing;
    private Supplier<JPopupMenu> menu = JPopupMenu::new;
    private AppendChoices next = (plan, vertex) -> List.of();
    private Fragment copied = new Fragment(ShownNet.none());
    private String copiedFrom = "";
    private int pasted;

    NetActions(DreammContext context, NetView view, ShownNet net) {
        this.context = context;
        this.view = view;
        this.net = net;
        this.edits = new NetEdits(net, context.domain().authoring());
        this.writing = new WriteInPlace(view);
    }

    NetEdits edits() {
        return edits;
    }

    void setMenu(Supplier<JPopupMenu> menu) {
        this.menu = menu;
    }

    void setAppendChoices(AppendChoices next) {
        this.next = next;
    }

    void tell(String text) {
        context.notices().show(text);
    }

    void refuse(String text) {
        context.notices().refused(text);
    }

    /** Why a command of that id cannot change the net now: no plan is open, or the profile locks it. */
    Optional<String> whyNotEdit(String id) {
        return !net.isOpen()
                ? Optional.of("no plan is open")
                : context.profile().shows(id)
                        ? context.profile().whyLocked(id)
                        : Optional.of("it is not part of this window");
    }

    /** The mode of what is made now (thesis 5.1). */
    Mode mode() {
        return context.editor().mode() == NetMode.RECOVERY ? Mode.RECOVERY : Mode.NOMINAL;
    }

    /** Makes an edit; says whether it was made. */
    boolean apply(Edit edit) {
        return context.apply(edit) instanceof EditResult.Done;
    }

    private void make(MakingEdit made) {
        if (apply(made.edit())) {
            context.editor().select(made.made());
            view.revealWhole(made.made());
        }
    }

    Set<String> selection() {
        return context.editor().selection();
    }

    /** The one vertex that is selected; empty where none or several are. */
    Optional<Vertex> selectedVertex() {
        return selection().size() == 1 ? net.vertex(selection().iterator().next()) : Optional.empty();
    }

    void move(Set<String> ids, double dx, double dy) {
        if ((dx != 0 || dy != 0) && whyNotEdit("net-move").isEmpty()) {
            Set<String> vertices = new LinkedHashSet<>(ids);
            boolean some = net.drawing().vertices().stream().anyMatch(v -> vertices.contains(v.id()))
                    || !edits.notes(vertices).isEmpty()
                    || !edits.frames().frames(vertices).isEmpty();
            if (some) {
                apply(edits.move(vertices, dx, dy));
            }
        }
    }

    void align(Alignment alignment) {
        apply(edits.moveTo(alignment.of(edits.centres(selection()))));
    }

    void delete() {
        edits.delete(selection()).ifPresent(this::apply);
    }

    void connect(String from, String to) {
        if (whyNotEdit("net-connect").isEmpty()) {
            Set<String> before = edges();
            if (apply(edits.connect(from, to, mode()))) {
                Set<String> drawn = edges();
                drawn.removeAll(before);
                context.editor().select(drawn); // what it asks for is chosen next
            }
        }
    }

    private Set<String> edges() {
        Set<String> ids = new LinkedHashSet<>();
        net.plan().inEdges().forEach(e -> ids.add(e.id()));
        net.plan().outEdges().forEach(e -> ids.add(e.id()));
        return ids;
    }

    void append(String from, double x, double y) {
        if (whyNotEdit("net-connect").isEmpty()) {
            make(edits.append(from, x, y, mode()));
        }
    }

    void addBlank(Kind kind, double x, double y) {
        if (whyNotEdit(kind == Kind.PLACE ? "net-add-place" : "net-add-transition")
                .isEmpty()) {
            LayoutPoint free = net.free(
                    Math.round(x / SnapWhileDragging.GRID) * SnapWhileDragging.GRID,
                    Math.round(y / SnapWhileDragging.GRID) * SnapWhileDragging.GRID);
            make(edits.add(kind, free.x(), free.y(), mode()));
        }
    }

    /** Where something has room behind a vertex, in drawing units. */
    LayoutPoint behind(String vertex) {
        LayoutPoint at = net.vertex(vertex).map(Vertex::centre).orElse(new LayoutPoint(0, 0));
        return net.free(at.x() + PASTE_OFFSET, at.y());
    }

    // ---- Copies

    void copy() {
        copied = edits.copy(selection());
        copiedFrom = net.plan().id();
        pasted = 0;
        int count = copied.part().places().size() + copied.part().transitions().size();
        tell("Copied " + count + (count == 1 ? " vertex" : " vertices"));
    }

    Optional<String> whyNotPaste() {
        return copied.isEmpty() ? Optional.of("nothing was copied yet") : whyNotEdit("net-paste");
    }

    /** Pastes at a point, or next to where it was copied. */
    void paste(Optional<LayoutPoint> at) {
        pasted++;
        if (at.isPresent() || !copiedFrom.equals(net.plan().id())) {
            LayoutPoint middle = at.orElseGet(view::centre);
            make(edits.paste(copied, middle.x(), middle.y()));
        } else {
            make(edits.pasteShifted(copied, pasted * 40, pasted * 40));
        }
    }

    void duplicate() {
        make(edits.pasteShifted(edits.copy(selection()), 40, 40));
    }

    // ---- Names and notes

    /** What is added next goes to what is selected. */
    void leaveChain() {
        context.additions().leaveChain();
    }

    void endWriting() {
        writing.end();
    }

    /** Lets the author write the name of the selected vertex, or the text of the selected note, where it stands. */
    void rename() {
        if (whyNotEdit("net-rename").isPresent()) {
            return;
        }
        selectedVertex().ifPresent(this::rename);
        edits.notes(selection()).stream().findFirst().ifPresent(this::writeNote);
        edits.frames().frames(selection()).stream().findFirst().ifPresent(this::writeTitle);
    }

    private void writeTitle(int index) {
        Plan plan = net.plan();
        NetFrame frame = plan.frames().get(index);
        net.drawing().frames().stream()
                .filter(box -> box.index() == index)
                .findFirst()
                .ifPresent(box -> writing.line(box.head(), frame.title(), text -> {
                    if (!text.equals(frame.title())) {
                        apply(new FrameEdit.SetFrame(plan.id(), index, frame.withTitle(text)));
                    }
                }));
    }

    /** Puts a frame around what is selected, and lets the author write its title. */
    void addFrame(LayoutPoint at) {
        make(edits.frames().add(selection(), at));
        rename();
    }

    private void rename(Vertex vertex) {
        Plan plan = net.plan();
        String name = plan.place(vertex.id())
                .map(p -> p.name())
                .orElseGet(() -> plan.transition(vertex.id()).map(t -> t.name()).orElse(""));
        writing.line(vertex, name, text -> {
            if (!text.equals(name)) {
                apply(new VertexEdit.NameVertex(plan.id(), vertex.id(), text));
            }
        });
    }

    private void writeNote(int index) {
        String plan = net.plan().id();
        String text = net.plan().notes().get(index).text();
        net.drawing().notes().stream()
                .filter(note -> note.index() == index)
                .findFirst()
                .ifPresent(note -> writing.paragraphs(note.box(), text, written -> {
                    if (!written.equals(text)) {
                        apply(new NoteEdit.SetNoteText(plan, index, written));
                    }
                }));
    }

    void addNote(LayoutPoint at) {
        MakingEdit made = edits.addNote(at.x(), at.y(), "Note");
        make(made);
        rename();
    }

    /** Puts the notes that lie nowhere below the net. */
    void layNotes() {
        Map<Integer, LayoutPoint> to = new LinkedHashMap<>();
        double y = net.drawing().bounds().maxY() + 40;
        for (int i = 0; i < net.plan().notes().size(); i++) {
            if (net.plan().notes().get(i).at().isEmpty()) {
                to.put(i, net.toPlan(net.drawing().bounds().x(), y));
                y += 60 + 16 * (net.plan().notes().get(i).text().length() / 32);
            }
        }
        apply(new NoteEdit.MoveNotes(net.plan().id(), to));
    }

    // ---- Menus and what comes from elsewhere

    /** Opens what is behind an element: a note or a name to write, the plan of a sub-mission. */
    void open(String id) {
        view.select(Set.of(id));
        Optional<String> sub = net.plan()
                .place(id)
                .flatMap(p -> p.subMissions().stream().map(SubMissionSpec::plan).findFirst());
        if (sub.isPresent()) {
            context.editor().open(sub.get());
        } else {
            rename();
        }
    }

    void openMenu(int x, int y) {
        menu.get().show(view.canvas(), x, y);
    }

    /** Offers what can come next at a vertex, in a menu. */
    void openAppendMenu(String vertex, int x, int y) {
        if (whyNotEdit("net-append").isPresent()) {
            return;
        }
        appendMenu(vertex).show(view.canvas(), x, y);
    }

    JPopupMenu appendMenu(String vertex) {
        JPopupMenu offers = new JPopupMenu();
        offers.setName("net-append-menu");
        Kind other = net.plan().place(vertex).isPresent() ? Kind.TRANSITION : Kind.PLACE;
        JMenuItem blank = new JMenuItem(other == Kind.PLACE ? "Blank place" : "Blank transition");
        blank.setName("net-append-blank");
        LayoutPoint free = behind(vertex);
        blank.addActionListener(e -> append(vertex, free.x(), free.y()));
        List<NextStep> steps = new ArrayList<>(next.after(net.plan(), vertex));
        for (int i = 0; i < steps.size(); i++) {
            NextStep step = steps.get(i);
            JMenuItem item = new JMenuItem(step.label());
            item.setName("net-append-" + (i + 1));
            item.addActionListener(e -> putBehind(step, vertex, free));
            offers.add(item);
        }
        if (!steps.isEmpty()) {
            offers.addSeparator();
        }
        offers.add(blank);
        return offers;
    }

    private void putBehind(NextStep step, String vertex, LayoutPoint free) {
        Plan before = net.plan();
        if (apply(edits.keepingTheRest(step.edit(before, vertex, net.toPlan(free.x(), free.y()), mode())))) {
            context.editor().select(newSince(before));
            view.revealWhole(selection());
        }
    }

    /** Puts something onto a vertex, or with a vertex of its own at a point of the drawing. */
    void put(NetDrop drop, Optional<String> vertex, LayoutPoint at) {
        Plan before = net.plan();
        Optional<String> whyNot = vertex.flatMap(id -> drop.whyNotOnto(before, id));
        if (whyNot.isPresent()) {
            refuse(whyNot.get());
            return;
        }
        Edit edit = vertex.map(id -> drop.onto(before, id, mode()))
                .orElseGet(() -> drop.at(before, net.toPlan(at.x(), at.y()), mode()));
        if (apply(edits.keepingTheRest(edit))) {
            Set<String> made = newSince(before);
            context.editor().select(vertex.map(Set::of).orElse(made));
            vertex.ifPresent(made::add);
            view.revealWhole(made);
        }
    }

    /** Puts something onto an edge; says whether edges hold such a thing. */
    boolean putOnEdge(NetDrop drop, String edge) {
        Optional<Edit> edit = drop.ontoEdge(net.plan(), edge);
        edit.filter(this::apply).ifPresent(made -> context.editor().select(Set.of(edge)));
        return edit.isPresent();
    }

    /** The vertices that a plan did not have. */
    private Set<String> newSince(Plan before) {
        Set<String> made = new LinkedHashSet<>();
        net.plan().places().stream().filter(p -> before.place(p.id()).isEmpty()).forEach(p -> made.add(p.id()));
        net.plan().transitions().stream()
                .filter(t -> before.transition(t.id()).isEmpty())
                .forEach(t -> made.add(t.id()));
        return made;
    }

    /** Selects all that the mode shows. */
    void selectAll() {
        Set<String> all = new LinkedHashSet<>();
        NetScene scene = view.scene();
        scene.vertices().forEach(vertex -> all.add(vertex.id()));
        scene.silhouettes().forEach(vertex -> all.add(vertex.id()));
        scene.edges().forEach(edge -> all.add(edge.id()));
        scene.notes().forEach(note -> all.add(NetScene.idOf(note.index())));
        scene.frames().forEach(frame -> all.add(NetScene.idOfFrame(frame.index())));
        context.editor().select(all);
    }
}
