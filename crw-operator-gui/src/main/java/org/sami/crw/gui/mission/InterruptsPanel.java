package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.ui.look.Icons;
import org.sami.ui.look.ScrolledPanel;
import org.sami.ui.value.WrappedText;

/** The buttons that running missions offer. Those for boats are pressed for the selected ones; where none is selected the plan asks. */
public final class InterruptsPanel extends JPanel {
    private static final int MOST_NAMED = 2; // the tooltip has all of them

    private final OperatorContext context;
    private final InterruptCommands commands;
    private final ScrolledPanel column = new ScrolledPanel(new MigLayout("insets 8, wrap 1, fillx", "[grow]", ""));
    private Optional<Shown> shown = Optional.empty();

    /** The interrupts of the session. */
    public InterruptsPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        commands = new InterruptCommands(context);
        add(column.inPane());
        context.models().interrupts().addListener(this::show);
        context.boats().addListener(() -> show(context.models().interrupts().snapshot()));
        show(context.models().interrupts().snapshot());
    }

    /** What the buttons say and do. */
    private record Shown(List<InterruptChoice> choices, List<String> boats) {}

    /** Nothing happens where all is as it was: a button that is rebuilt has no focus any longer, and no finger on it. */
    private void show(List<InterruptChoice> choices) {
        commands.show(choices);
        Shown now = new Shown(choices, context.boats().boats());
        if (shown.equals(Optional.of(now))) {
            return;
        }
        shown = Optional.of(now);
        Optional<String> focused = Arrays.stream(column.getComponents())
                .filter(Component::isFocusOwner)
                .map(Component::getName)
                .findFirst();
        column.removeAll();
        for (InterruptChoice choice : choices) {
            column.add(button(choice), "growx, hmin 40, wmin 0");
        }
        if (choices.isEmpty()) {
            WrappedText nothing =
                    new WrappedText("No running mission offers an interrupt. Each that does has its button here.");
            column.add(nothing, "growx, wmin 0");
        }
        column.revalidate();
        column.repaint();
        focused.ifPresent(name -> Arrays.stream(column.getComponents())
                .filter(component -> name.equals(component.getName()))
                .forEach(Component::requestFocusInWindow));
    }

    private JButton button(InterruptChoice choice) {
        List<String> boats = choice.asksForBoats() ? context.boats().boats() : List.of();
        String whom = !choice.asksForBoats() ? "" : boats.isEmpty() ? "…" : " for " + String.join(", ", boats);
        String brief = boats.size() > MOST_NAMED ? " for " + boats.size() + " boats" : whom;
        JButton button = new JButton(choice.name() + brief, Icons.normal("interrupt"));
        button.setName("interrupt-" + choice.name().strip().replaceAll("[^A-Za-z0-9]+", "-"));
        button.setHorizontalAlignment(JButton.LEADING);
        Optional<String> whyNot =
                context.whyNotAct().or(() -> choice.isEnabled() ? Optional.empty() : Optional.of(choice.whyNot()));
        button.setEnabled(whyNot.isEmpty());
        String key = commands.keyText(choice.name());
        button.setToolTipText(whyNot.orElse(
                        boats.isEmpty() && choice.asksForBoats()
                                ? "Press " + choice.name() + "; you are asked for which boats"
                                : "Press " + choice.name() + whom)
                + (key.isEmpty() ? "" : " (" + key + ")"));
        button.addActionListener(e -> context.tell(
                context.session().press(choice.name(), choice.mission(), boats), "Pressed " + choice.name() + whom));
        return button;
    }
}
