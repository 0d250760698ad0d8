package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.ScrolledPanel;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.WrappedText;

/**
 * The buttons that running missions offer, each mission's below its name. A button keeps its place and its key until its mission ends; those that
 * cannot be undone stand apart and are confirmed below. Those for boats are pressed for the selected ones; where none is selected the plan asks, and as
 * long as it asks the press can be withdrawn.
 */
public final class InterruptsPanel extends JPanel {
    private static final int ROW = Spacing.HIT_TARGET_FIELD;

    private final OperatorContext context;
    private final InterruptPlaces places = new InterruptPlaces();
    private final InterruptPress press;
    private final InterruptCommands commands;
    private final InterruptConfirm confirm;
    private final ScrolledPanel column = new ScrolledPanel(
            new MigLayout("novisualpadding, insets 4 8 0 8, gap 0 4, wrap 1, fillx, hidemode 3", "[grow,fill]", ""));
    private final Map<Key, InterruptRow> rows = new HashMap<>();
    private List<Object> arranged = List.of();

    private record Key(long mission, String name) {}

    /** The interrupts of the session. */
    public InterruptsPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        press = new InterruptPress(context);
        commands = new InterruptCommands(context, places, press);
        confirm = new InterruptConfirm(context, press);
        add(column.inPane());
        add(confirm, BorderLayout.SOUTH);
        press.addListener(this::proposed);
        context.commands()
                .get("interrupt-confirm")
                .addPropertyChangeListener(change -> showRows()); // its reason is another once the person's rights are
        context.models().interrupts().addListener(this::show);
        context.boats().addListener(() -> show(context.models().interrupts().snapshot()));
        show(context.models().interrupts().snapshot());
    }

    private void proposed() {
        Component focused =
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        boolean hadFocus = focused != null && confirm.isAncestorOf(focused);
        Optional<InterruptRow> row = press.proposed().map(now -> rows.get(key(now.choice())));
        confirm.show(context);
        if (row.isPresent()) {
            if (!isShowing()) { // the key was pressed while the panel lay behind another
                context.commands().find("panel-interrupts").ifPresent(command -> command.run());
            }
            confirm.focus();
        } else if (hadFocus) {
            rows.values().stream().findFirst().ifPresent(InterruptRow::focus); // else the next button has it
        }
    }

    private static Key key(InterruptChoice choice) {
        return new Key(choice.mission(), choice.name());
    }

    private void showRows() {
        context.models().interrupts().snapshot().forEach(choice -> {
            InterruptRow row = rows.get(key(choice));
            if (row != null) {
                row.show(choice, commands.keyText(choice), commands.withdrawKey());
            }
        });
    }

    /** Buttons stay the same components as long as they are there: one that is rebuilt has no focus any longer, and no finger on it. */
    private void show(List<InterruptChoice> choices) {
        List<InterruptPlaces.Group> groups = places.show(choices);
        commands.show();
        press.look(choices);
        rows.keySet().retainAll(choices.stream().map(InterruptsPanel::key).toList());
        List<Object> order = new ArrayList<>();
        for (InterruptPlaces.Group group : groups) {
            order.add(group.isRoom() ? "room " + group.rows() : group.mission() + " " + group.rows());
            group.choices().forEach(choice -> {
                order.add(key(choice));
                rows.computeIfAbsent(key(choice), key -> new InterruptRow(context, press, name(choice)))
                        .show(choice, commands.keyText(choice), commands.withdrawKey());
            });
        }
        if (!order.equals(arranged) || column.getComponentCount() == 0) {
            arranged = order;
            arrange(groups);
        }
    }

    /** The name of a button: that of its interrupt, and where another mission has one of that name its number as well. */
    private String name(InterruptChoice choice) {
        String name = "interrupt-" + choice.name().strip().replaceAll("[^A-Za-z0-9]+", "-");
        boolean second = rows.keySet().stream().anyMatch(key -> key.name().equals(choice.name()));
        return second ? name + "-" + choice.mission() : name;
    }

    private void arrange(List<InterruptPlaces.Group> groups) {
        Component focused =
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        column.removeAll();
        for (InterruptPlaces.Group group : groups) {
            column.add(heading(group), "wmin 0");
            boolean apart = false;
            for (InterruptChoice choice : group.choices()) {
                String gap = choice.isFinal() && !apart ? ", gaptop 10" : "";
                apart |= choice.isFinal();
                column.add(rows.get(key(choice)), "wmin 0" + gap);
            }
            for (int i = group.choices().size(); i < group.rows(); i++) {
                column.add(new JLabel(" "), "h " + ROW + "!");
            }
        }
        if (groups.isEmpty()) {
            WrappedText none =
                    new WrappedText("No running mission offers an interrupt. Each that does has its buttons here.");
            none.setColor(SemanticColor.MUTED);
            column.add(none, "wmin 0, gaptop 8");
        }
        column.revalidate();
        column.repaint();
        if (focused != null && column.isAncestorOf(focused)) {
            focused.requestFocusInWindow();
        }
    }

    private JLabel heading(InterruptPlaces.Group group) {
        String words = group.isRoom() ? " " : context.titles().words(group.mission());
        JLabel heading = new JLabel(words) {
            @Override
            public void updateUI() {
                super.updateUI();
                setFont(Fonts.small()); // of the scale that is in force
            }
        };
        heading.setToolTipText(words);
        LookColors.foreground(heading, SemanticColor.MUTED);
        return heading;
    }
}
