package org.sami.dreamm.help;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.context.DreammContext;
import org.sami.ui.command.Command;
import org.sami.ui.command.PopupWindow;

/** The command that explains what has the focus, or else what is selected in the net. */
public final class HelpCommands {
    private final DreammContext context;
    private final HelpTopics topics;

    /** The help of a window's domain. */
    public HelpCommands(DreammContext context) {
        this.context = Objects.requireNonNull(context, "context");
        topics = new HelpTopics(context.vocabulary(), context.additions().library());
    }

    /** Adds the command to the window's. */
    public void addTo(Window owner) {
        context.commands()
                .add(new Command(
                                "help-here",
                                "Explain what is selected",
                                () -> topic().ifPresent(
                                                topic -> PopupWindow.open(owner, "Help", close -> new HelpView(topic))))
                        .withKey("shift F1")
                        .unless(() -> topic().isPresent()
                                ? Optional.empty()
                                : Optional.of("select an event, a vertex or an edge first")));
    }

    private Optional<HelpTopic> topic() {
        return around(KeyboardFocusManager.getCurrentKeyboardFocusManager().getPermanentFocusOwner())
                .or(this::selected);
    }

    /** What the innermost of the components around one explains. */
    static Optional<HelpTopic> around(Component component) {
        for (Component at = component; at != null; at = at.getParent()) {
            if (at instanceof Explained explained && explained.help().isPresent()) {
                return explained.help();
            }
        }
        return Optional.empty();
    }

    private Optional<HelpTopic> selected() {
        return context.editor()
                .plan()
                .flatMap(plan -> context.editor().selection().stream()
                        .flatMap(id -> topics.element(plan, id).stream())
                        .findFirst());
    }
}
