package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The findings about a project that is being edited. {@link #after} checks only the plans that an edit changed and, where that shows in
 * what other plans see of them, the plans that run them and that they run; the result is that of {@link PlanChecks#check(Project,
 * Vocabulary)}. Changes are recognised by identity, because edits leave untouched plans as they are. Immutable but for what is looked up lazily:
 * one thread at a time, which need not be a window's.
 */
public final class LiveChecks {
    private final Project project;
    private final ProjectContext context;
    private final List<List<Finding>> byPlan;
    private final List<Finding> findings;
    private final int checked;

    private LiveChecks(Project project, ProjectContext context, List<List<Finding>> byPlan, int checked) {
        this.project = project;
        this.context = context;
        this.byPlan = byPlan;
        this.checked = checked;
        List<Finding> all = new ArrayList<>();
        byPlan.forEach(all::addAll);
        all.sort(DocumentOrder.BY_POINTER);
        this.findings = List.copyOf(all);
    }

    /** Checks all plans of a project. */
    public static LiveChecks of(Project project, Vocabulary vocabulary) {
        ProjectContext context = new ProjectContext(project, vocabulary);
        List<List<Finding>> byPlan = project.plans().stream()
                .map(p -> PlanChecks.check(context.of(p)))
                .toList();
        return new LiveChecks(project, context, byPlan, byPlan.size());
    }

    /** The project that was checked. */
    public Project project() {
        return project;
    }

    /** The findings about all plans, in the order of the document. */
    public List<Finding> findings() {
        return findings;
    }

    /** How many plans had to be checked for these findings. */
    public int plansChecked() {
        return checked;
    }

    /** The findings about another version of the project, before or after this one. */
    public LiveChecks after(Project other) {
        if (!project.globals().equals(other.globals()) || !uniqueIds(project) || !uniqueIds(other)) {
            return of(other, context.vocabulary());
        }
        ProjectContext next = context.after(other);
        Set<String> again = concerned(next);
        List<List<Finding>> all = new ArrayList<>();
        int count = 0;
        for (int i = 0; i < other.plans().size(); i++) {
            Plan plan = other.plans().get(i);
            if (i < byPlan.size() && sameNet(project.plans().get(i), plan) && !again.contains(plan.id())) {
                all.add(byPlan.get(i));
            } else {
                all.add(PlanChecks.check(next.of(plan)));
                count++;
            }
        }
        return new LiveChecks(other, next, List.copyOf(all), count);
    }

    private static boolean uniqueIds(Project project) {
        Set<String> ids = new HashSet<>();
        return project.plans().stream().allMatch(p -> ids.add(p.id()));
    }

    /**
     * Ids of the plans that see something of a plan which is another now, or of their order: those that run it or that it runs, at any depth;
     * where other tokens go in or out of it, all that hang together with it.
     */
    private Set<String> concerned(ProjectContext next) {
        Map<String, Plan> was = new HashMap<>();
        project.plans().forEach(p -> was.put(p.id(), p));
        Set<String> changed = new HashSet<>(was.keySet());
        Set<String> sameFlow = new HashSet<>();
        for (Plan plan : next.project().plans()) {
            Optional<Plan> old = Optional.ofNullable(was.get(plan.id()));
            if (old.isEmpty()) {
                changed.add(plan.id());
            } else if (sameNet(old.get(), plan)) {
                changed.remove(plan.id());
            } else {
                PlanInterface before = PlanInterface.of(context.of(old.get()));
                PlanInterface after = PlanInterface.of(next.of(plan));
                if (before.equals(after)) {
                    changed.remove(plan.id());
                } else if (before.hasSameFlow(after)) {
                    sameFlow.add(plan.id());
                }
            }
        }
        for (Plan plan : next.project().plans()) { // of two plans that run it, the first says what it sees
            if (!parents(context, plan.id()).equals(parents(next, plan.id()))) {
                changed.add(plan.id());
                sameFlow.remove(plan.id());
            }
        }
        Set<String> concerned = new HashSet<>();
        for (String id : changed) {
            for (ProjectContext version : List.of(context, next)) {
                if (sameFlow.contains(id)) {
                    reach(id, concerned, plan -> parents(version, plan));
                    reach(id, concerned, plan -> children(version, plan));
                } else {
                    reach(id, concerned, plan -> neighbours(version, plan));
                }
            }
        }
        return concerned;
    }

    private static List<String> neighbours(ProjectContext version, String plan) {
        List<String> neighbours = new ArrayList<>(parents(version, plan));
        neighbours.addAll(children(version, plan));
        return neighbours;
    }

    private static List<String> children(ProjectContext version, String plan) {
        return version.plan(plan)
                .map(p -> List.copyOf(ProjectContext.children(p)))
                .orElse(List.of());
    }

    private static List<String> parents(ProjectContext version, String plan) {
        return version.parents(plan).stream().map(Plan::id).toList();
    }

    private static void reach(String from, Set<String> reached, Function<String, List<String>> next) {
        Set<String> seen = new HashSet<>(Set.of(from));
        Deque<String> open = new ArrayDeque<>(next.apply(from));
        while (!open.isEmpty()) {
            String plan = open.pop();
            if (seen.add(plan)) {
                next.apply(plan).forEach(open::push);
            }
        }
        reached.addAll(seen);
    }

    /** Whether two versions of a plan are the same but for what no finding speaks of: descriptions, notes, layout, test cases. */
    @SuppressWarnings("ReferenceEquality") // an edit leaves the lists that it does not change as they are
    private static boolean sameNet(Plan a, Plan b) {
        return a == b
                || (a.id().equals(b.id())
                        && a.title().equals(b.title())
                        && a.places() == b.places()
                        && a.transitions() == b.transitions()
                        && a.inEdges() == b.inEdges()
                        && a.outEdges() == b.outEdges()
                        && a.variables() == b.variables()
                        && a.reads() == b.reads()
                        && a.tasks() == b.tasks());
    }
}
