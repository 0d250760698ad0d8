package org.sami.dreamm.issues;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.tryout.NetChanges;
import org.sami.spn.edit.Fix;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * The issues of the project: what live checks found and, until the plan is changed, what the last deep check found; those that the filter
 * shows, and the one that the author looks at. To look at one opens its plan and highlights its elements. On the document's thread.
 */
public final class IssueList {
    private final EditorState editor;
    private final Predicate<Finding> offered;
    private final LiveFindings live;
    private final DeepSearch deep;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private IssueFilter filter = IssueFilter.ALL;
    private boolean onlyOpenPlan;
    private List<Issue> all = List.of();
    private List<Issue> shown = List.of();
    private Optional<Issue> current = Optional.empty();
    private Supplier<List<Finding>> notes = List::of;

    /**
     * The issues of a document.
     *
     * @param offered which findings the author sees
     */
    public IssueList(
            ProjectDocument document,
            EditorState editor,
            Predicate<Finding> offered,
            LiveFindings live,
            DeepSearch deep) {
        this.editor = Objects.requireNonNull(editor, "editor");
        this.offered = Objects.requireNonNull(offered, "offered");
        this.live = Objects.requireNonNull(live, "live");
        this.deep = Objects.requireNonNull(deep, "deep");
        live.addListener(this::refresh);
        deep.addListener(this::refresh);
        document.addListener((DocumentChange change) -> followDeep(change));
        editor.addListener(new EditorListener() {
            @Override
            public void planOpened() {
                if (onlyOpenPlan) {
                    refresh();
                }
            }
        });
        refresh();
    }

    /**
     * Shows further findings after all others.
     *
     * @param further asked now, and whenever the list is made anew
     */
    public void showAlso(Supplier<List<Finding>> further) {
        notes = Objects.requireNonNull(further, "further");
        refresh();
    }

    /** A change of the plan that was searched, or of one that it runs, makes what was found old; undone, it is back. */
    private void followDeep(DocumentChange change) {
        if (NetChanges.in(change)) {
            deep.follow(change.after());
        }
    }

    private void refresh() {
        List<Issue> next = new ArrayList<>();
        Map<Finding, Integer> seen = new HashMap<>();
        live.findings()
                .forEach(finding ->
                        next.add(new Issue(seen.merge(finding, 1, Integer::sum), finding, Optional.empty(), false)));
        deep.outcome()
                .ifPresent(found -> found.result()
                        .findings()
                        .forEach(finding ->
                                next.add(new Issue(next.size(), finding.finding(), finding.witness(), true))));
        notes.get().forEach(note -> next.add(new Issue(next.size(), note, Optional.empty(), true)));
        next.removeIf(issue -> !offered.test(issue.finding()));
        all = List.copyOf(next);
        filtered();
    }

    private void filtered() {
        IssueFilter in = onlyOpenPlan ? filter.of(Optional.of(editor.planId().orElse(""))) : filter;
        shown = all.stream().filter(in::shows).toList();
        Optional<Issue> looked = current;
        current = current.flatMap(
                was -> shown.stream().filter(is -> is.key().equals(was.key())).findFirst());
        boolean gone = looked.isPresent()
                && all.stream().noneMatch(is -> is.key().equals(looked.get().key()));
        if (gone) {
            editor.highlight(Set.of()); // its marks go with it
        }
        listeners.forEach(Runnable::run);
    }

    /** All issues of the project: errors and warnings in the order of the document, then those of the last deep check. */
    public List<Issue> all() {
        return all;
    }

    /** Those that the filter shows. */
    public List<Issue> shown() {
        return shown;
    }

    /** How many there are in all. */
    public IssueCounts counts() {
        return IssueCounts.of(all);
    }

    /** Whether newer findings are on their way. */
    public boolean isChecking() {
        return live.isChecking();
    }

    /** Which are shown. */
    public IssueFilter filter() {
        return filter;
    }

    /** Shows others. */
    public void setFilter(IssueFilter next) {
        filter = Objects.requireNonNull(next, "next");
        filtered();
    }

    /** Shows only those of the plan that is open, whichever that is, or those of all plans. */
    public void setOnlyOpenPlan(boolean only) {
        onlyOpenPlan = only;
        filtered();
    }

    /** Whether only those of the plan that is open are shown. */
    public boolean isOnlyOpenPlan() {
        return onlyOpenPlan;
    }

    /** The issue that the author looks at; empty where none is. */
    public Optional<Issue> current() {
        return current;
    }

    /** Looks at an issue: its plan is opened and what it is about is highlighted. */
    public void lookAt(Issue issue) {
        current = Optional.of(issue);
        show(issue);
        listeners.forEach(Runnable::run);
    }

    private void show(Issue issue) {
        Finding finding = issue.finding();
        editor.open(finding.plan());
        editor.highlight(editor.plan()
                .filter(plan -> plan.id().equals(finding.plan()))
                .map(plan -> drawn(plan, finding.elements()))
                .orElse(Set.of()));
    }

    /** The vertices and edges of some elements: an event or a sub-mission is shown by its vertex. */
    static Set<String> drawn(Plan plan, List<String> elements) {
        Set<String> drawn = new LinkedHashSet<>(elements);
        for (Place place : plan.places()) {
            boolean spokenOf = place.outputs().stream().anyMatch(output -> elements.contains(output.id()))
                    || place.subMissions().stream().anyMatch(sub -> elements.contains(sub.id()));
            if (spokenOf) {
                drawn.add(place.id());
            }
        }
        for (Transition transition : plan.transitions()) {
            if (transition.inputs().stream().anyMatch(input -> elements.contains(input.id()))) {
                drawn.add(transition.id());
            }
        }
        return drawn;
    }

    /** Looks at the next issue that is shown, or the one before; behind the last is the first. */
    public void step(boolean forwards) {
        if (shown.isEmpty()) {
            return;
        }
        int at = current.map(shown::indexOf).orElse(forwards ? -1 : 0);
        lookAt(shown.get(Math.floorMod(at + (forwards ? 1 : -1), shown.size())));
    }

    /** The fix that one key makes for the issue that is looked at; empty where it has none. */
    public Optional<Fix> firstFix() {
        return current.flatMap(issue -> issue.fixes().stream().findFirst());
    }

    /** Tells somebody when something has changed. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }
}
