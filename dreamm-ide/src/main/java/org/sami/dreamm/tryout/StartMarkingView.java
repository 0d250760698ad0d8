package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TaskSpec;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.SemanticColor;

/** Puts tokens into the place that is selected on the net, for a run that begins there. */
final class StartMarkingView extends JPanel {
    private final transient DreammContext context;
    private final transient TryOut tryOut;
    private final transient StartMarkingSetup setup;
    private final JLabel title = new JLabel();
    private final JPanel tokens = new JPanel(new MigLayout("insets 0, gap 8 4, wrap 4"));
    private boolean filling;

    StartMarkingView(DreammContext context, TryOut tryOut, StartMarkingSetup setup) {
        super(new MigLayout("insets 8 12 8 12, gap 6, wrap", "[grow, fill]", "[][grow, fill][]"));
        this.context = context;
        this.tryOut = tryOut;
        this.setup = setup;
        title.setName("marking-place");
        tokens.setOpaque(false);
        add(title, "wmin 0");
        JScrollPane scroll = new JScrollPane(tokens);
        scroll.setBorder(null);
        scroll.setOpaque(false);
        scroll.getViewport().setOpaque(false);
        add(scroll, "wmin 0, hmin 0");
        JPanel buttons = new JPanel(new MigLayout("insets 0, gap 8"));
        buttons.setOpaque(false);
        buttons.add(new CommandButton(context.commands().get("try-start-at")), "hmin 32");
        JButton clear = new JButton("Empty all places");
        clear.setName("marking-clear");
        clear.addActionListener(e -> setup.clear());
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

    private void refresh() {
        if (filling) {
            return;
        }
        Optional<Place> place = place();
        title.setFont(Fonts.text());
        title.setForeground((place.isPresent() ? SemanticColor.TEXT : SemanticColor.MUTED).get());
        title.setText(place.map(p -> p.end()
                        ? "A mission that stands in the end place " + p.id() + " is over"
                        : "What stands in " + (p.name().isEmpty() ? p.id() : p.name()))
                .orElse("Select a place on the net to put tokens into it"));
        tokens.removeAll();
        place.filter(p -> !p.end()).ifPresent(this::fill);
        tokens.revalidate();
        tokens.repaint();
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
