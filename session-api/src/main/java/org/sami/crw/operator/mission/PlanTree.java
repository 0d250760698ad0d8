package org.sami.crw.operator.mission;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * The plans of a project as lines in the order of its mission tree (thesis 5.1), all of them or those that a search finds. Plans that stand
 * nowhere in the tree follow in a folder of their own, or by themselves where there is no tree. Immutable.
 */
public final class PlanTree {
    private static final String OTHERS = "Other plans";

    private final Project project;
    private final List<String> words;
    private final List<Line> lines = new ArrayList<>();

    /**
     * A line of the tree.
     *
     * @param number among all lines of the whole tree, from 0: a line keeps it in every search
     * @param depth number of lines above it in its branch
     * @param title of the plan or folder
     * @param plan empty for a folder
     */
    public record Line(int number, int depth, String title, Optional<Plan> plan) {
        public Line {
            Objects.requireNonNull(title, "title");
            Objects.requireNonNull(plan, "plan");
        }
    }

    private PlanTree(Project project, String search) {
        this.project = project;
        words = List.of(search.strip().toLowerCase(Locale.ROOT).split("\\s+"));
        List<MissionTreeNode> roots = new ArrayList<>(project.missionTree());
        List<MissionTreeNode> others = others();
        if (roots.isEmpty()) {
            roots.addAll(others);
        } else if (!others.isEmpty()) {
            roots.add(new MissionTreeNode(OTHERS, Optional.empty(), others));
        }
        int number = 0;
        for (MissionTreeNode root : roots) {
            number = add(root, 0, number);
        }
    }

    /** The whole tree. */
    public static List<Line> of(Project project) {
        return of(project, "");
    }

    /**
     * The plans whose title, id or description has all words of a search, regardless of case, below the folders and plans in which they stand.
     *
     * @param search empty for the whole tree
     */
    public static List<Line> of(Project project, String search) {
        return List.copyOf(new PlanTree(project, search).lines);
    }

    private List<MissionTreeNode> others() {
        Set<String> shown = new HashSet<>();
        project.missionTree().forEach(root -> collect(root, shown));
        return project.plans().stream()
                .filter(plan -> !shown.contains(plan.id()))
                .map(plan -> new MissionTreeNode("", Optional.of(plan.id()), List.of()))
                .toList();
    }

    private static void collect(MissionTreeNode node, Set<String> plans) {
        node.plan().ifPresent(plans::add);
        node.children().forEach(child -> collect(child, plans));
    }

    /** Adds a node with those below it; a node in which nothing is found is left out, and counted. */
    private int add(MissionTreeNode node, int depth, int number) {
        Optional<Plan> plan = node.plan().flatMap(project::plan);
        int at = lines.size();
        int next = number + 1;
        for (MissionTreeNode child : node.children()) {
            next = add(child, depth + 1, next);
        }
        boolean below = lines.size() > at;
        if (below || plan.filter(this::isFound).isPresent()) {
            lines.add(at, new Line(number, depth, title(node, plan), plan));
        }
        return next;
    }

    private static String title(MissionTreeNode node, Optional<Plan> plan) {
        return plan.map(Plan::title).orElse(node.label());
    }

    private boolean isFound(Plan plan) {
        String text = (plan.title() + ' ' + plan.id() + ' ' + plan.description()).toLowerCase(Locale.ROOT);
        return words.stream().allMatch(text::contains);
    }
}
