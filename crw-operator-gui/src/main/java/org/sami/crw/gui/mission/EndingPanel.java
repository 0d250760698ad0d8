package org.sami.crw.gui.mission;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.WidthTrackingPanel;
import org.sami.ui.value.WrappedText;

/** Says what an abort or a completion will do, in place, and has it done or left. Not seen while nothing is proposed. */
final class EndingPanel extends FoldingPanel {
    /** The key that lets the mission run, while the panel has the focus. */
    static final KeyStroke LEAVE = KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0);

    private static final int MOST_HIGH = 96;
    private static final int NARROW = 560;

    private final WrappedText title = WrappedText.heading("");
    private final WrappedText lines = new WrappedText("");
    private final CommandButton confirm;
    private final Consumer<Boolean> end;
    private final Runnable focusBack;
    private final Runnable changed;
    private Optional<Boolean> abort = Optional.empty();
    private String mission = "";
    private List<String> consequences = List.of();
    private final transient Fold narrow = foldBelowWidth(NARROW, folded -> write());

    /**
     * Nothing is proposed.
     *
     * @param end receives true for an abort, false for a completion
     * @param focusBack gives the focus to the mission
     * @param changed is called when something is proposed, or no longer
     */
    EndingPanel(CommandRegistry commands, Consumer<Boolean> end, Runnable focusBack, Runnable changed) {
        super(new MigLayout("novisualpadding, insets 8 12 8 12, gap 8 4, fillx, wrap 3", "[grow,fill][][]"));
        this.end = end;
        this.focusBack = focusBack;
        this.changed = changed;
        setName("mission-ending");
        title.setName("mission-ending-title");
        lines.setName("mission-ending-lines");
        confirm = CommandButton.confirming(commands.get("mission-end-confirm"));
        CommandButton leave = CommandButton.confirming(commands.get("mission-end-leave"));
        add(title, "wmin 60");
        add(confirm);
        add(leave);
        JScrollPane scroll = new JScrollPane(new WidthTrackingPanel(lines));
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setOpaque(false);
        scroll.getViewport().setOpaque(false);
        add(scroll, "span, growx, wmin 60, hmin 24, hmax " + Look.px(MOST_HIGH));
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(LEAVE, "leave");
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), "confirm");
        getActionMap().put("leave", commands.get("mission-end-leave"));
        getActionMap().put("confirm", commands.get("mission-end-confirm"));
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(
                this, () -> BorderFactory.createMatteBorder(Look.px(2), 0, Look.px(2), 0, SemanticColor.WARNING.get()));
        setVisible(false);
    }

    /** What is proposed: true = abort, false = complete. */
    Optional<Boolean> proposed() {
        return abort;
    }

    /** Proposes an end; the button that does it has the focus, and Escape leaves. */
    void propose(boolean toAbort, String mission) {
        abort = Optional.of(toAbort);
        this.mission = mission;
        consequences = List.of();
        write();
        confirm.setText(toAbort ? "Abort it" : "Complete it");
        setVisible(true);
        confirm.requestFocusInWindow();
        changed.run();
    }

    /** Says what it will do now. */
    void say(List<String> consequences) {
        this.consequences = List.copyOf(consequences);
        write();
    }

    /** Where the heading would wrap next to the buttons, the mission's name leads the lines below it. */
    private void write() {
        String what = abort.orElse(false) ? "Abort " : "Complete ";
        List<String> below = new ArrayList<>(consequences);
        if (narrow.isFolded()) {
            below.add(0, mission);
        }
        String text = String.join("\n", below);
        String heading = what + (narrow.isFolded() ? "it" : mission) + "?";
        if (!text.equals(lines.getText()) || !heading.equals(title.getText())) {
            title.setText(heading);
            lines.setText(text);
            revalidate();
        }
    }

    /** Proposes nothing any longer. */
    void leave() {
        if (abort.isPresent()) {
            abort = Optional.empty();
            Component focused =
                    KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
            boolean hadFocus = focused != null && isAncestorOf(focused);
            setVisible(false);
            if (hadFocus) {
                focusBack.run(); // else the next button has it, which may be the fleet stop
            }
            changed.run();
        }
    }

    /** Has it done. */
    void confirm() {
        abort.ifPresent(toAbort -> {
            leave();
            end.accept(toAbort);
        });
    }
}
