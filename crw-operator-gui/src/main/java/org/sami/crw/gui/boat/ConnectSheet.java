package org.sami.crw.gui.boat;

import java.awt.Component;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.ui.command.Command;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** The sheet with the form that connects boats, and the command that opens it; over a session here and over one in another process. On the event thread. */
public final class ConnectSheet {
    private ConnectSheet() {}

    /** Opens it in the window in which a component lies. */
    public static Command command(OperatorContext context, Component inside) {
        return new Command("boat-connect", "Connect a boat…", () -> open(context, inside))
                .withKey("ctrl B")
                .withIcon("connect");
    }

    private static void open(OperatorContext context, Component inside) {
        WindowSheet.in(inside)
                .open(new Sheet("boat-connect-sheet", context.say("Connect a boat"), new ConnectForm(context)));
    }
}
