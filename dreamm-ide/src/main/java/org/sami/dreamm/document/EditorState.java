package org.sami.dreamm.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.sami.picture.net.NetMode;
import org.sami.picture.net.NetScene;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * What the author looks at: the open plan, how much of its net is shown, what is selected, and what is spoken of. It follows the document:
 * what is gone is neither open nor selected, a plan that gets another id stays open. On the event thread.
 */
public final class EditorState {
    private final ProjectDocument document;
    private final List<EditorListener> listeners = new CopyOnWriteArrayList<>();
    private Optional<String> plan;
    private NetMode mode = NetMode.NOMINAL;
    private Set<String> selection = Set.of();
    private Set<String> highlight = Set.of();

    /** The state of an editor that has the project's first plan open. */
    public EditorState(ProjectDocument document) {
        this.document = document;
        this.plan = first(document.project());
        document.addListener(this::follow);
    }

    private static Optional<String> first(Project project) {
        return project.plans().stream().map(Plan::id).findFirst();
    }

    /** The id of the plan that is open; empty where the project has none. */
    public Optional<String> planId() {
        return plan;
    }

    /** The plan that is open, as it is now. */
    public Optional<Plan> plan() {
        return plan.flatMap(document::plan);
    }

    /** How much of the net is shown. What is made in recovery mode is a recovery part (thesis 5.1). */
    public NetMode mode() {
        return mode;
    }

    /** Ids of the vertices, edges, events, sub-missions, notes ({@link NetScene#idOf}) and frames ({@link NetScene#idOfFrame}) that are selected, in the order of their selection. */
    public Set<String> selection() {
        return selection;
    }

    /** Ids of what is spoken of elsewhere, such as in a finding. */
    public Set<String> highlight() {
        return highlight;
    }

    /** Opens a plan; nothing of it is selected yet. One that is not there is left alone. */
    public void open(String id) {
        if (!plan.equals(Optional.of(id)) && document.plan(id).isPresent()) {
            opened(Optional.of(id));
        }
    }

    /** Opens a plan and selects elements of it. */
    public void open(String id, Collection<String> elements) {
        open(id);
        select(elements);
    }

    /** Shows the net in another mode. */
    public void setMode(NetMode next) {
        if (mode != Objects.requireNonNull(next, "next")) {
            mode = next;
            tell(EditorListener::modeChanged);
        }
    }

    /** Selects these and no others. */
    public void select(Collection<String> ids) {
        Set<String> next = Collections.unmodifiableSet(new LinkedHashSet<>(ids));
        if (!List.copyOf(next).equals(List.copyOf(selection))) {
            selection = next;
            tell(EditorListener::selectionChanged);
        }
    }

    /** Speaks of these and no others. */
    public void highlight(Collection<String> ids) {
        Set<String> next = Collections.unmodifiableSet(new LinkedHashSet<>(ids));
        if (!next.equals(highlight)) {
            highlight = next;
            tell(EditorListener::highlightChanged);
        }
    }

    private void follow(DocumentChange change) {
        if (change.isOpened()) {
            opened(first(change.after()));
            return;
        }
        if (plan.isPresent() && change.after().plan(plan.get()).isEmpty()) {
            opened(renamed(change).or(() -> first(change.after())));
        } else if (plan.isEmpty()) {
            first(change.after()).ifPresent(id -> opened(Optional.of(id)));
        }
        keepWhatIsThere();
    }

    /** The open plan under its new id: the plan that is now where it was, if no plan was removed. */
    private Optional<String> renamed(DocumentChange change) {
        List<String> before = change.before().plans().stream().map(Plan::id).toList();
        List<String> after = change.after().plans().stream().map(Plan::id).toList();
        int index = before.indexOf(plan.orElseThrow());
        return before.size() == after.size() && !before.contains(after.get(index))
                ? Optional.of(after.get(index))
                : Optional.empty();
    }

    private void keepWhatIsThere() {
        if (selection.isEmpty() && highlight.isEmpty()) {
            return;
        }
        Set<String> there = plan().map(EditorState::ids).orElse(Set.of());
        select(selection.stream().filter(there::contains).toList());
        highlight(highlight.stream().filter(there::contains).toList());
    }

    private static Set<String> ids(Plan plan) {
        Set<String> ids = new LinkedHashSet<>(plan.elementIds());
        for (int i = 0; i < plan.notes().size(); i++) {
            ids.add(NetScene.idOf(i));
        }
        for (int i = 0; i < plan.frames().size(); i++) {
            ids.add(NetScene.idOfFrame(i));
        }
        return ids;
    }

    private void opened(Optional<String> next) {
        plan = next;
        boolean selected = !selection.isEmpty();
        boolean highlighted = !highlight.isEmpty();
        selection = Set.of();
        highlight = Set.of();
        tell(EditorListener::planOpened);
        if (selected) {
            tell(EditorListener::selectionChanged);
        }
        if (highlighted) {
            tell(EditorListener::highlightChanged);
        }
    }

    private void tell(Consumer<EditorListener> what) {
        new ArrayList<>(listeners).forEach(what);
    }

    /** Adds somebody who hears what the author looks at, after those who were added before. */
    public void addListener(EditorListener listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    /** Tells somebody no longer. */
    public void removeListener(EditorListener listener) {
        listeners.remove(listener);
    }
}
