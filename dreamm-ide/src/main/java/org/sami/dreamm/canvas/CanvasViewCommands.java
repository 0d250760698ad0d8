package org.sami.dreamm.canvas;

import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.sami.dreamm.context.DreammContext;
import org.sami.picture.net.NetMode;
import org.sami.spn.drawing.NetDetail;
import org.sami.ui.canvas.CanvasKey;
import org.sami.ui.command.Command;
import org.sami.ui.net.NetKey;
import org.sami.ui.net.NetView;

/** The commands that show the net otherwise: zoom and pan, modes, what is written. */
final class CanvasViewCommands {
    private final DreammContext context;
    private final NetView view;
    private final Detail detail;

    /** What is written at the net, and whether tokens are shown. */
    interface Detail {
        NetDetail get();

        void set(NetDetail detail);

        void toggleTokens();
    }

    CanvasViewCommands(DreammContext context, NetView view, Detail detail) {
        this.context = context;
        this.view = view;
        this.detail = detail;
    }

    void add() {
        for (Command command : NetView.commands(() -> Optional.of(view))) {
            switch (NetKey.valueOf(
                    command.id().substring("net-".length()).replace('-', '_').toUpperCase(Locale.ROOT))) {
                case MODE, CLEAR, OPEN -> {} // an author's are others
                case LEFT, RIGHT, UP, DOWN ->
                    key(command, "alt " + command.id().substring(4).toUpperCase(Locale.ROOT));
                case NEXT -> key(command, "PERIOD", "TAB");
                case PREVIOUS -> key(command, "COMMA", "shift TAB");
                case ZOOM_IN, ZOOM_OUT, FIT ->
                    context.commands().add(command.withIcon(command.id().substring(4)));
                default -> context.commands().add(command);
            }
        }
        mode(NetMode.NOMINAL, "Nominal mode");
        mode(NetMode.RECOVERY, "Recovery mode");
        mode(NetMode.ALL, "Nominal and recovery parts", "shift R");
        toggle("net-show-events", "Show or fold events", d -> d.withEvents(!d.events()), "E");
        toggle("net-show-markups", "Show or fold markup", d -> d.withMarkups(!d.markups()), "M");
        toggle("net-show-requirements", "Show or fold requirements", d -> d.withRequirements(!d.requirements()), "Q");
        key(new Command("net-show-tokens", "Show or fold tokens", detail::toggleTokens), "K");
    }

    private void key(Command command, String... keys) {
        context.commands().add(command.withFocusKeys(CanvasKey.strokes(keys)));
        command.bindTo(view.canvas());
    }

    private void mode(NetMode mode, String title, String... keys) {
        key(
                new Command(
                        "net-mode-" + mode.name().toLowerCase(Locale.ROOT),
                        title,
                        () -> context.editor().setMode(mode)),
                keys);
    }

    private void toggle(String id, String title, UnaryOperator<NetDetail> change, String key) {
        key(new Command(id, title, () -> detail.set(change.apply(detail.get()))), key);
    }
}
