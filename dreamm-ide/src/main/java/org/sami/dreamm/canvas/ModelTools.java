package org.sami.dreamm.canvas;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.ButtonGroup;
import javax.swing.JToggleButton;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.picture.net.NetMode;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** The row above the net: which parts are shown, and what authors do most. */
final class ModelTools {
    private static final String[] LEFT = {"net-add-place", "net-add-transition"};
    private static final String[] LEFT_WITH_ROOM = {"net-connect", "net-add-note"};
    private static final String[] RIGHT = {"undo", "redo", "net-layout-layers", "net-zoom-out", "net-zoom-in", "net-fit"
    };

    private ModelTools() {}

    static CommandRow of(DreammContext context) {
        CommandRow row = new CommandRow();
        row.setName("model-tools");
        ButtonGroup modes = new ButtonGroup();
        for (NetMode mode : NetMode.values()) {
            JToggleButton button = new JToggleButton(mode.label());
            button.setName("net-mode-" + mode.name().toLowerCase(Locale.ROOT));
            Command command = context.commands().get(button.getName());
            button.setToolTipText(command.title() + " (" + command.keyText() + ")");
            button.setVisible(!command.isHidden());
            button.setMinimumSize(null);
            button.setSelected(context.editor().mode() == mode);
            button.addActionListener(e -> command.run());
            button.putClientProperty("JButton.buttonType", "toolBarButton");
            button.putClientProperty("FlatLaf.minimumHeight", Look.px(Spacing.HIT_TARGET_FIELD));
            modes.add(button);
            row.left(button);
            context.editor().addListener(new EditorListener() {
                @Override
                public void modeChanged() {
                    button.setSelected(context.editor().mode() == mode);
                }
            });
        }
        List<CommandButton> making = Stream.of(LEFT)
                .map(id -> CommandButton.iconOnly(context.commands().get(id)))
                .toList();
        making.forEach(row::left);
        List<CommandButton> withRoom = Stream.of(LEFT_WITH_ROOM)
                .map(id -> CommandButton.iconOnly(context.commands().get(id)))
                .toList();
        withRoom.forEach(row::left);
        for (String id : RIGHT) {
            context.commands().find(id).ifPresent(command -> row.spare(CommandButton.iconOnly(command)));
        }
        withRoom.forEach(row::leaveOut);
        making.forEach(row::leaveOut);
        return row;
    }
}
