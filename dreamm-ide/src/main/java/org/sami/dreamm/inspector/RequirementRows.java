package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.wizard.ComputeRequirements;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.look.Spacing;

/** The requirements of one edge as rows of choices, read from left to right as they are said: "≥ 1 Generic", "Take All Relevant". */
final class RequirementRows extends Form {
    private static final InRequirement WANTS_ONE = InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1);
    private static final OutRequirement TAKES_ONE = OutRequirement.of(Action.TAKE, 1, TokenKind.GENERIC);
    private static final int MOST = 9999;

    private final transient DreammContext context;
    private final transient Plan plan;

    /** The rows of an in edge. */
    RequirementRows(DreammContext context, Plan plan, InEdge edge) {
        this.context = context;
        this.plan = plan;
        setName("inspector-edge");
        List<InRequirement> all = edge.requirements();
        List<InRequirement> shown =
                all.stream().filter(r -> !r.equals(WANTS_ONE)).toList();
        heading("The transition waits until here " + (all.size() > 1 ? "are" : "is"));
        flag(
                "≥ 1 Generic (implied)",
                "inspector-implied-generic",
                "The generic token of the plan stands here; drawn folded where it goes on to one edge (thesis, Table 4)",
                all.contains(WANTS_ONE),
                on -> set(edge, on ? with(all, WANTS_ONE) : without(all, WANTS_ONE)));
        for (int i = 0; i < shown.size(); i++) {
            InRequirement r = shown.get(i);
            int at = all.indexOf(r);
            wide(inRow(edge, r, at, i));
        }
        add(edge.id(), edge.locked(), shown.isEmpty(), () -> set(edge, with(all, fresh(all))));
    }

    /** The rows of an out edge. */
    RequirementRows(DreammContext context, Plan plan, OutEdge edge) {
        this.context = context;
        this.plan = plan;
        setName("inspector-edge");
        List<OutRequirement> all = edge.requirements();
        List<OutRequirement> shown =
                all.stream().filter(r -> !r.equals(TAKES_ONE)).toList();
        heading("When the transition fires");
        flag(
                "Take 1 Generic (implied)",
                "inspector-implied-generic",
                "The generic token of the plan goes on over this edge (thesis, Table 4)",
                all.contains(TAKES_ONE),
                on -> set(edge, on ? with(all, TAKES_ONE) : without(all, TAKES_ONE)));
        for (int i = 0; i < shown.size(); i++) {
            wide(outRow(edge, shown.get(i), all.indexOf(shown.get(i)), i));
        }
        add(
                edge.id(),
                edge.locked(),
                shown.isEmpty(),
                () -> set(
                        edge,
                        with(
                                without(all, OutRequirement.unconditional()),
                                OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_PROXY))));
    }

    private static InRequirement fresh(List<InRequirement> all) {
        return all.contains(InRequirement.allRelevant())
                ? InRequirement.of(TokenKind.ANY_PROXY, Match.AT_LEAST, 1)
                : InRequirement.allRelevant();
    }

    private void add(String edge, boolean locked, boolean none, Runnable more) {
        if (none) {
            note("No other requirement.", SemanticColor.MUTED);
        }
        JPanel buttons = new JPanel(new MigLayout("insets 0, gap 4, hidemode 3"));
        buttons.setOpaque(false);
        buttons.add(button("+ Requirement", "inspector-add-requirement", "Add a requirement", more));
        javax.swing.JButton compute = button(
                "Compute",
                "inspector-compute",
                locked
                        ? "Compute what the plan's events need here: not possible, the edge is locked"
                        : "Compute what the plan's events need here; what stands here now is replaced",
                () -> context.apply(new ComputeRequirements(
                        plan.id(), Set.of(edge), context.additions().library())));
        compute.setEnabled(!locked);
        buttons.add(compute);
        wide(buttons);
    }

    private JComponent inRow(InEdge edge, InRequirement r, int at, int row) {
        JPanel panel = panel();
        if (r.kind() != TokenKind.UNCONDITIONAL) {
            List<Match> matches = r.kind() == TokenKind.RELEVANT
                    ? List.of(Match.values())
                    : List.of(Match.ZERO, Match.LESS_THAN, Match.AT_LEAST, Match.EXACTLY);
            panel.add(
                    named(
                            combo(
                                    matches,
                                    Optional.of(r.match()),
                                    RequirementRows::words,
                                    m -> put(
                                            edge,
                                            at,
                                            new InRequirement(
                                                    r.kind(), m, counted(m) ? Math.max(1, r.n()) : 0, r.task()))),
                            "inspector-match-" + row,
                            "How many"),
                    "hmin " + Spacing.HIT_TARGET);
            if (counted(r.match())) {
                panel.add(number(
                        r.n(),
                        "inspector-count-" + row,
                        n -> put(edge, at, new InRequirement(r.kind(), r.match(), n, r.task()))));
            }
        }
        List<TokenKind> kinds = List.of(
                TokenKind.GENERIC,
                TokenKind.ANY_PROXY,
                TokenKind.ANY_TASK,
                TokenKind.ANY_TOKEN,
                TokenKind.TASK,
                TokenKind.RELEVANT,
                TokenKind.UNCONDITIONAL);
        panel.add(
                named(
                        combo(kinds, Optional.of(r.kind()), k -> kind(k, true), k -> put(edge, at, changed(r, k))),
                        "inspector-kind-" + row,
                        "Of which tokens"),
                "growx, pushx, wmin 0, hmin " + Spacing.HIT_TARGET);
        if (r.kind() == TokenKind.TASK) {
            panel.add(
                    task(r.task(), row, t -> put(edge, at, new InRequirement(r.kind(), r.match(), r.n(), t))),
                    "wmin 0");
        }
        panel.add(button(
                "×",
                "inspector-remove-requirement-" + row,
                "Remove this requirement",
                () -> set(edge, removed(edge.requirements(), at))));
        return panel;
    }

    private JComponent outRow(OutEdge edge, OutRequirement r, int at, int row) {
        JPanel panel = panel();
        if (r.kind() != TokenKind.UNCONDITIONAL) {
            panel.add(
                    named(
                            combo(
                                    List.of(Action.values()),
                                    Optional.of(r.action()),
                                    a -> a == Action.TAKE ? "Take" : a == Action.CONSUME ? "Consume" : "Add",
                                    a -> put(edge, at, new OutRequirement(r.kind(), r.n(), a, r.task()))),
                            "inspector-action-" + row,
                            "What becomes of the tokens: taken along, consumed, or added as copies"),
                    "hmin " + Spacing.HIT_TARGET);
            panel.add(
                    named(
                            combo(
                                    List.of(true, false),
                                    Optional.of(r.takesAll()),
                                    all -> all ? "All" : "Number",
                                    all -> put(
                                            edge,
                                            at,
                                            new OutRequirement(
                                                    r.kind(), all ? OutRequirement.ALL : 1, r.action(), r.task()))),
                            "inspector-quantity-" + row,
                            "All tokens, or so many"),
                    "hmin " + Spacing.HIT_TARGET);
            if (!r.takesAll()) {
                panel.add(number(
                        r.n(),
                        "inspector-count-" + row,
                        n -> put(edge, at, new OutRequirement(r.kind(), n, r.action(), r.task()))));
            }
        }
        panel.add(
                named(
                        combo(
                                List.of(TokenKind.values()),
                                Optional.of(r.kind()),
                                k -> kind(k, false),
                                k -> put(edge, at, changed(r, k))),
                        "inspector-kind-" + row,
                        "Of which tokens"),
                "growx, pushx, wmin 0, hmin " + Spacing.HIT_TARGET);
        if (r.kind() == TokenKind.TASK) {
            panel.add(
                    task(r.task(), row, t -> put(edge, at, new OutRequirement(r.kind(), r.n(), r.action(), t))),
                    "wmin 0");
        }
        panel.add(button(
                "×",
                "inspector-remove-requirement-" + row,
                "Remove this requirement",
                () -> set(edge, removed(edge.requirements(), at))));
        return panel;
    }

    private InRequirement changed(InRequirement r, TokenKind kind) {
        if (kind == TokenKind.UNCONDITIONAL) {
            return InRequirement.unconditional();
        }
        Match match = r.match() == Match.ALL && kind != TokenKind.RELEVANT ? Match.AT_LEAST : r.match();
        return new InRequirement(kind, match, counted(match) ? Math.max(1, r.n()) : 0, firstTask(kind));
    }

    private OutRequirement changed(OutRequirement r, TokenKind kind) {
        return kind == TokenKind.UNCONDITIONAL
                ? OutRequirement.unconditional()
                : new OutRequirement(kind, r.n(), r.action(), firstTask(kind));
    }

    private String firstTask(TokenKind kind) {
        return kind == TokenKind.TASK ? tasks().stream().findFirst().orElse("Task") : "";
    }

    /** The plan's tasks, then the classes of the domain. */
    private List<String> tasks() {
        List<String> tasks =
                new ArrayList<>(plan.tasks().stream().map(t -> t.name()).toList());
        tasks.addAll(context.vocabulary().taskClasses().keySet());
        return tasks.stream().distinct().toList();
    }

    private JComponent task(String now, int row, java.util.function.Consumer<String> given) {
        return named(
                combo(tasks(), Optional.of(now), t -> t, given),
                "inspector-task-" + row,
                "Which task, or class of tasks");
    }

    private static JPanel panel() {
        JPanel panel = new JPanel(new MigLayout("insets 0, gap 4, fillx"));
        panel.setOpaque(false);
        return panel;
    }

    private static <C extends JComponent> C named(C component, String name, String tip) {
        component.setName(name);
        component.setToolTipText(tip);
        component.getAccessibleContext().setAccessibleName(tip);
        return component;
    }

    private static JSpinner number(int n, String name, java.util.function.IntConsumer given) {
        JSpinner spinner = new JSpinner(new SpinnerNumberModel(Math.max(1, n), 1, MOST, 1));
        named(spinner, name, "How many tokens");
        spinner.addChangeListener(e -> given.accept((Integer) spinner.getValue()));
        return spinner;
    }

    private static boolean counted(Match match) {
        return match == Match.LESS_THAN || match == Match.AT_LEAST || match == Match.EXACTLY;
    }

    private static String words(Match match) {
        return switch (match) {
            case ZERO -> "No";
            case LESS_THAN -> "<";
            case AT_LEAST -> "≥";
            case EXACTLY -> "=";
            case ALL -> "All";
        };
    }

    private static String kind(TokenKind kind, boolean in) {
        return switch (kind) {
            case GENERIC -> "Generic";
            case ANY_PROXY -> "Proxy";
            case ANY_TASK -> "Task";
            case ANY_TOKEN -> "Token";
            case TASK -> "named Task";
            case RELEVANT -> "Relevant";
            case SUB_MISSION_TOKENS -> "Sub-mission";
            case UNCONDITIONAL -> in ? "No Condition" : "Enter With Nobody";
        };
    }

    private void put(InEdge edge, int at, InRequirement r) {
        List<InRequirement> next = new ArrayList<>(edge.requirements());
        next.set(at, r);
        set(edge, r.kind() == TokenKind.UNCONDITIONAL ? List.of(r) : next);
    }

    private void put(OutEdge edge, int at, OutRequirement r) {
        List<OutRequirement> next = new ArrayList<>(edge.requirements());
        next.set(at, r);
        set(edge, r.kind() == TokenKind.UNCONDITIONAL ? List.of(r) : next);
    }

    private void set(InEdge edge, List<InRequirement> requirements) {
        context.apply(new EdgeEdit.SetInRequirements(plan.id(), edge.id(), requirements));
    }

    private void set(OutEdge edge, List<OutRequirement> requirements) {
        context.apply(new EdgeEdit.SetOutRequirements(plan.id(), edge.id(), requirements));
    }

    private static <T> List<T> with(List<T> list, T more) {
        List<T> next = new ArrayList<>(list);
        next.add(more);
        return next;
    }

    private static <T> List<T> without(List<T> list, T less) {
        return list.stream().filter(r -> !r.equals(less)).toList();
    }

    private static <T> List<T> removed(List<T> list, int at) {
        List<T> next = new ArrayList<>(list);
        next.remove(at);
        return next;
    }
}
