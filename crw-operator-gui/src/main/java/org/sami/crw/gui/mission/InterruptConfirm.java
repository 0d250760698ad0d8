package org.sami.crw.gui.mission;

import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.value.WrappedText;

/** Says, below the buttons, what of an interrupt cannot be undone, and has it pressed or left. Not seen while nothing is to be confirmed. */
final class InterruptConfirm extends JPanel {
    private final InterruptPress press;
    private final WrappedText text = new WrappedText("");
    private final CommandButton leave;

    InterruptConfirm(OperatorContext context, InterruptPress press) {
        super(new MigLayout("novisualpadding, insets 6 8 8 8, gap 8 4, fillx, wrap 2", "[grow,fill][grow,fill]"));
        this.press = press;
        setName("interrupt-confirmation");
        Command confirm = context.commands()
                .add(new Command("interrupt-confirm", "Press it", press::confirm)
                        .withFocusKeys(List.of(KeyStroke.getKeyStroke("ENTER")))
                        .withIcon("interrupt")
                        .unless(this::whyNot));
        Command leaving = context.commands()
                .add(new Command("interrupt-leave", "Leave it", press::leave)
                        .withFocusKeys(List.of(KeyStroke.getKeyStroke("ESCAPE")))
                        .withIcon("close")
                        .unless(this::whyNot));
        text.setName("interrupt-confirmation-text");
        leave = CommandButton.confirming(leaving);
        add(text, "span, growx, wmin 60");
        add(leave);
        add(CommandButton.confirming(confirm));
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), "leave");
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ENTER"), "confirm");
        getActionMap().put("leave", leaving);
        getActionMap().put("confirm", confirm);
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(
                this, () -> BorderFactory.createMatteBorder(Look.px(2), 0, 0, 0, SemanticColor.WARNING.get()));
        setVisible(false);
    }

    private Optional<String> whyNot() {
        return press.proposed().isPresent()
                ? Optional.empty()
                : Optional.of("no interrupt that cannot be undone was pressed");
    }

    /** Shows what is to be confirmed now, if anything is. */
    void show(OperatorContext context) {
        context.commands().get("interrupt-confirm").refresh();
        context.commands().get("interrupt-leave").refresh();
        press.proposed().ifPresent(now -> {
            String whom = now.boats().isEmpty()
                    ? (now.choice().asksForBoats() ? context.say("; which boats is asked then") : "")
                    : " for " + String.join(", ", now.boats());
            text.setText("Press " + press.title(now.choice()) + whom + "? It cannot be undone. "
                    + context.say(now.choice().noWayBack()));
        });
        setVisible(press.proposed().isPresent());
        revalidate();
        repaint();
    }

    /** Brings the focus to where Enter presses it and Escape leaves it. */
    void focus() {
        leave.requestFocusInWindow();
    }
}
