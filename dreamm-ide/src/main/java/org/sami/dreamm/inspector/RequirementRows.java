package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.help.Explained;
import org.sami.dreamm.help.HelpTopic;
import org.sami.dreamm.help.HelpTopics;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.wizard.ComputeRequirements;
import org.sami.spn.wizard.SoundRequirements;
import org.sami.ui.look.Spacing;

/**
 * The requirements of one edge as rows of choices, read from left to right as in the language: "≥ 1 Generic", "Take All Relevant". The implied
 * generic token (thesis, Table 4) is one check box.
 *
 * @param <R> the requirement
 */
abstract class RequirementRows<R> extends Form {
    private static final int MOST = 9999;
    private static final int PROPOSED = 4;

    private final transient DreammContext context;
    private final transient Plan plan;
    private final String edge;
    private final transient List<R> all;

    final transient SoundRequirements requirements;

    RequirementRows(DreammContext context, Plan plan, String edge, List<R> all) {
        this.context = context;
        this.plan = plan;
        this.edge = edge;
        this.all = List.copyOf(all);
        requirements = new SoundRequirements(
                context.document().project(),
                plan,
                context.vocabulary(),
                context.additions().library());
        setName("inspector-edge");
    }

    /** Adds the rows; to be called by a subclass when it is ready to be asked. */
    final void fill(String heading, R implied, String words, boolean locked) {
        heading(heading);
        flag(
                words + " (implied)",
                "inspector-implied-generic",
                help("implied-generic"),
                all.contains(implied),
                on -> set(
                        on
                                ? with(implied)
                                : all.stream().filter(r -> !r.equals(implied)).toList()));
        boolean none = true;
        for (int i = 0; i < all.size(); i++) {
            if (!all.get(i).equals(implied)) {
                none = false;
                wide(row(i));
                String help = help(kind(all.get(i))
                        .name()
                        .toLowerCase(java.util.Locale.ROOT)
                        .replace('_', '-'));
                if (!help.isEmpty()) {
                    note(help, SemanticColor.MUTED);
                }
            }
        }
        if (none) {
            note("No other requirement.", SemanticColor.MUTED);
        }
        buttons(implied, locked);
    }

    private void buttons(R implied, boolean locked) {
        JPanel buttons = new JPanel(new MigLayout("novisualpadding, insets 0, gap 4"));
        buttons.setOpaque(false);
        JButton add = button(
                "+ Requirement", "inspector-add-requirement", "Add a requirement", () -> set(with(begun(implied))));
        add.setEnabled(!offered().isEmpty());
        buttons.add(add);
        JButton compute = button(
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
        propose();
    }

    /** A button for each of the likeliest requirements that make sense here. */
    private void propose() {
        List<R> sound = proposed().stream().limit(PROPOSED).toList();
        if (sound.isEmpty()) {
            return;
        }
        JPanel row = new JPanel(new MigLayout("novisualpadding, insets 0, gap 4, wrap 2"));
        row.setOpaque(false);
        for (int i = 0; i < sound.size(); i++) {
            R r = sound.get(i);
            row.add(button(
                    "+ " + said(r),
                    "inspector-propose-requirement-" + i,
                    "Add the requirement " + said(r),
                    () -> set(with(r))));
        }
        wide(row);
    }

    /** What makes sense here, as far as the profile has it. */
    private List<R> proposed() {
        return sound().stream()
                .filter(r -> context.profile().allows(profileId(kind(r))))
                .filter(r -> context.profile().allows(quantityId(r)))
                .toList();
    }

    /** The likeliest requirement that makes sense here, else one of the kinds that the profile has; not the implied one, which has no row. */
    private R begun(R implied) {
        R fresh =
                proposed().stream().filter(r -> !r.equals(implied)).findFirst().orElseGet(this::fresh);
        R offered = offered().contains(kind(fresh))
                ? fresh
                : ofKind(fresh, offered().get(0));
        return offered.equals(implied) ? moreThanImplied() : offered;
    }

    /** The kinds of tokens that the profile has; relevant ones only where an input event names some, or where they stand. */
    private List<TokenKind> offered() {
        return kinds().stream()
                .filter(kind -> context.profile().allows(profileId(kind)))
                .filter(kind -> kind != TokenKind.RELEVANT
                        || namesTokens()
                        || all.stream().anyMatch(r -> kind(r) == TokenKind.RELEVANT))
                .toList();
    }

    final <T> List<T> allowed(Stream<T> options, Function<T, String> id) {
        return options.filter(option -> context.profile().allows(id.apply(option)))
                .toList();
    }

    private JPanel row(int at) {
        R r = all.get(at);
        JPanel panel = new Row(() ->
                topic(new HelpTopics(context.vocabulary(), context.additions().library()), r));
        if (kind(r) != TokenKind.UNCONDITIONAL) {
            quantity(panel, r, at);
        }
        panel.add(
                named(
                        combo(offered(), Optional.of(kind(r)), this::words, k -> put(at, ofKind(r, k))),
                        "inspector-kind-" + at,
                        "Of which tokens"),
                "growx, pushx, wmin 0, hmin " + Spacing.HIT_TARGET);
        if (kind(r) == TokenKind.TASK) {
            panel.add(
                    named(
                            combo(tasks(), Optional.of(task(r)), t -> t, t -> put(at, ofTask(r, t))),
                            "inspector-task-" + at,
                            "Which task, or class of tasks"),
                    "wmin 0, hmin " + Spacing.HIT_TARGET);
        }
        panel.add(button("×", "inspector-remove-requirement-" + at, "Remove this requirement", () -> {
            List<R> next = new ArrayList<>(all);
            next.remove(at);
            set(next);
        }));
        return panel;
    }

    /** What one requirement asks for. */
    private static final class Row extends JPanel implements Explained {
        private final transient Supplier<HelpTopic> topic;

        Row(Supplier<HelpTopic> topic) {
            super(new MigLayout("novisualpadding, insets 0, gap 4, fillx"));
            this.topic = topic;
            setOpaque(false);
        }

        @Override
        public Optional<HelpTopic> help() {
            return Optional.of(topic.get());
        }
    }

    abstract HelpTopic topic(HelpTopics topics, R r);

    abstract void quantity(JPanel panel, R r, int at);

    abstract TokenKind kind(R r);

    abstract String task(R r);

    abstract R ofKind(R r, TokenKind kind);

    abstract R ofTask(R r, String task);

    /** The requirements that make sense on the edge and do not stand there, the likeliest first. */
    abstract List<R> sound();

    /** Whether an input event of the edge's transition can name tokens. */
    abstract boolean namesTokens();

    /** A requirement in words. */
    abstract String said(R r);

    /** The id by which a profile names how many tokens a requirement asks for, or what becomes of them. */
    abstract String quantityId(R r);

    /** A requirement to begin with where none makes more sense. */
    abstract R fresh();

    /** A requirement of generic tokens that is not the implied one. */
    abstract R moreThanImplied();

    /** The edit that gives an edge these requirements. */
    abstract Edit edit(String plan, String edge, List<R> requirements);

    abstract List<TokenKind> kinds();

    abstract String unconditional();

    /** The id by which a profile names a kind of tokens. */
    abstract String profileId(TokenKind kind);

    private void set(List<R> requirements) {
        context.apply(edit(plan.id(), edge, requirements));
    }

    /** Replaces one; an unconditional one stands alone. */
    final void put(int at, R r) {
        List<R> next = new ArrayList<>(all);
        next.set(at, r);
        set(kind(r) == TokenKind.UNCONDITIONAL ? List.of(r) : next);
    }

    private List<R> with(R more) {
        List<R> next = new ArrayList<>(
                all.stream().filter(r -> kind(r) != TokenKind.UNCONDITIONAL).toList());
        next.add(more);
        return next;
    }

    final String firstTask(TokenKind kind) {
        return kind == TokenKind.TASK ? tasks().stream().findFirst().orElse("Task") : "";
    }

    /** The plan's tasks, then the classes of the domain. */
    private List<String> tasks() {
        List<String> tasks =
                new ArrayList<>(plan.tasks().stream().map(t -> t.name()).toList());
        tasks.addAll(context.vocabulary().taskClasses().keySet());
        return tasks.stream().distinct().toList();
    }

    private String help(String id) {
        return context.additions().library().requirementHelp().getOrDefault(id, "");
    }

    static void choice(JPanel panel, JComponent box, String name, String tip) {
        panel.add(named(box, name, tip), "hmin " + Spacing.HIT_TARGET);
    }

    static void number(JPanel panel, int n, int at, IntConsumer given) {
        JSpinner spinner = new JSpinner(new SpinnerNumberModel(Math.max(1, n), 1, MOST, 1));
        Consumer<Integer> give = given::accept;
        spinner.addChangeListener(e -> give.accept((Integer) spinner.getValue()));
        panel.add(named(spinner, "inspector-count-" + at, "How many tokens"), "w 64!, hmin " + Spacing.HIT_TARGET);
    }

    private static <C extends JComponent> C named(C component, String name, String tip) {
        component.setName(name);
        component.setToolTipText(tip);
        component.getAccessibleContext().setAccessibleName(tip);
        return component;
    }

    private String words(TokenKind kind) {
        return switch (kind) {
            case GENERIC -> "Generic";
            case ANY_PROXY -> "Proxy";
            case ANY_TASK -> "Task";
            case ANY_TOKEN -> "Token";
            case TASK -> "named Task";
            case RELEVANT -> "Relevant";
            case SUB_MISSION_TOKENS -> "Sub-mission";
            case UNCONDITIONAL -> unconditional();
        };
    }
}
