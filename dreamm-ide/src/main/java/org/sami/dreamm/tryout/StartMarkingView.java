package org.sami.dreamm.tryout;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.palette.SemanticColor;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.FieldType;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.StrongLabel;
import org.sami.ui.value.ValueEditor;
import org.sami.ui.value.ValueField;

/** Puts tokens into the place that is selected on the net, for a run that begins there, and gives what the plan asks at its start. */
final class StartMarkingView extends JPanel {
    private final transient DreammContext context;
    private final transient TryOut tryOut;
    private final transient StartMarkingSetup setup;
    private final JLabel title = new JLabel();
    private final JPanel tokens = new JPanel(new MigLayout("insets 0, gap 8 4, wrap 4"));
    private final JPanel asked = new JPanel(new MigLayout("insets 8 0 0 0, gap 8 4, wrap 1", "[220:280:360, fill]"));
    private transient Optional<Plan> askedOf = Optional.empty();
    private boolean filling;

    StartMarkingView(DreammContext context, TryOut tryOut, StartMarkingSetup setup) {
        super(new MigLayout("insets 8 12 8 12, gap 6, wrap", "[grow, fill]", "[][grow, fill][]"));
        this.context = context;
        this.tryOut = tryOut;
        this.setup = setup;
        title.setName("marking-place");
        tokens.setOpaque(false);
        asked.setOpaque(false);
        asked.setName("marking-asked");
        JPanel both = new JPanel(new MigLayout("insets 0, gap 0, wrap 1"));
        both.setOpaque(false);
        both.add(tokens);
        both.add(asked);
        add(title, "wmin 0");
        JScrollPane scroll = new JScrollPane(both);
        scroll.getVerticalScrollBar().setUnitIncrement(Look.px(24));
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setOpaque(false);
        scroll.getViewport().setOpaque(false);
        add(scroll, "wmin 0, hmin 0");
        JPanel buttons = new JPanel(new MigLayout("insets 0, gap 8"));
        buttons.setOpaque(false);
        buttons.add(new CommandButton(context.commands().get("try-start-at")), "hmin 32");
        JButton clear = new JButton("Empty all places");
        clear.setName("marking-clear");
        clear.addActionListener(e -> {
            askedOf = Optional.empty();
            setup.clear();
        });
        buttons.add(clear, "hmin 32");
        add(buttons);
        context.editor().addListener(new EditorListener() {
            @Override
            public void selectionChanged() {
                refresh();
            }

            @Override
            public void planOpened() {
                refresh();
            }
        });
        context.document().addListener(change -> refresh());
        setup.addListener(this::refresh);
        refresh();
    }

    private Optional<Place> place() {
        Optional<Plan> plan = context.editor().plan();
        return context.editor().selection().stream()
                .map(id -> plan.flatMap(p -> p.place(id)))
                .flatMap(Optional::stream)
                .findFirst();
    }

    private String name(Place place) {
        return context.editor()
                .plan()
                .map(plan -> new ElementNames(plan, context.vocabulary()).of(place))
                .orElse(place.id());
    }

    private void refresh() {
        if (filling) {
            return;
        }
        Optional<Place> place = place();
        LookColors.foreground(title, place.isPresent() ? SemanticColor.TEXT : SemanticColor.MUTED);
        title.setText(place.map(p -> p.end()
                        ? "A mission that stands in the end place \"" + name(p) + "\" is over"
                        : "What stands in " + name(p))
                .orElse("Select a place on the net to put tokens into it"));
        tokens.removeAll();
        place.filter(p -> !p.end()).ifPresent(this::fill);
        tokens.revalidate();
        tokens.repaint();
        ask(context.editor().plan());
    }

    /** Editors of what the plan asks; they stay while somebody types there. */
    private void ask(Optional<Plan> plan) {
        if (plan.equals(askedOf)) {
            return;
        }
        askedOf = plan;
        asked.removeAll();
        List<AskedAtStart> all =
                plan.map(p -> AskedAtStart.of(p, context.vocabulary())).orElse(List.of());
        if (!all.isEmpty()) {
            JLabel heading = new StrongLabel("What the plan asks at its start");
            asked.add(heading);
        }
        all.forEach(this::ask);
        asked.revalidate();
        asked.repaint();
    }

    private void ask(AskedAtStart each) {
        FieldType field = each.field();
        ValueEditor editor = context.values()
                .editor(new ValueField(
                        each.key(), ValueField.words(field.name()), field.type(), field.unit(), field.help()));
        setup.given(each.key()).or(each::defaultValue).ifPresent(editor::show);
        editor.addListener(() -> editor.entry()
                .value()
                .filter(value -> editor.isTouched() && !Optional.of(value).equals(setup.given(each.key())))
                .ifPresent(value -> {
                    filling = true;
                    setup.give(each.key(), value);
                    filling = false;
                }));
        JLabel label =
                new JLabel(ValueField.words(field.name()) + (field.unit().isEmpty() ? "" : " (" + field.unit() + ")"));
        label.setToolTipText(each.key() + ": " + field.help());
        label.setLabelFor(editor.focusTarget());
        asked.add(label);
        JPanel row = new JPanel(new BorderLayout());
        row.setOpaque(false);
        row.add(editor.component());
        asked.add(ProfileGuard.mark(row, "marking-value"));
    }

    private void fill(Place place) {
        StartMarking.Tokens at = setup.at(place.id());
        JSpinner generic = new JSpinner(new SpinnerNumberModel(at.generic(), 0, 99, 1));
        generic.setName("marking-generic");
        List<JCheckBox> robots = new ArrayList<>();
        List<JCheckBox> tasks = new ArrayList<>();
        Runnable put = () -> {
            filling = true;
            setup.put(
                    new StartMarking.Tokens(place.id(), (Integer) generic.getValue(), checked(robots), checked(tasks)));
            filling = false;
        };
        generic.addChangeListener(e -> put.run());
        JLabel label = new JLabel("Generic");
        label.setLabelFor(generic);
        tokens.add(label);
        tokens.add(generic, "wrap, hmin 32");
        tryOut.robotNames().forEach(robot -> add(robots, robot, at.proxies().contains(robot), put));
        List<TaskSpec> known = context.editor().plan().map(Plan::tasks).orElse(List.of());
        known.forEach(task -> add(tasks, task.name(), at.tasks().contains(task.name()), put));
    }

    private void add(List<JCheckBox> boxes, String name, boolean checked, Runnable put) {
        JCheckBox box = new JCheckBox(name, checked);
        box.setName("marking-" + name);
        ProfileGuard.mark(box, "marking-token");
        box.setOpaque(false);
        box.addActionListener(e -> put.run());
        boxes.add(box);
        tokens.add(box);
    }

    private static List<String> checked(List<JCheckBox> boxes) {
        return boxes.stream()
                .filter(JCheckBox::isSelected)
                .map(JCheckBox::getText)
                .toList();
    }
}
